#include "render/shader_program.hpp"

#include "embed/embedded_file.hpp"

#include <span>
#include <stdexcept>
#include <vector>

namespace drape::render {

std::span<const EmbeddedFile> embeddedShaders();

namespace {

std::string_view shaderFile(std::string_view name) {
  for (const EmbeddedFile& file : embeddedShaders()) {
    if (file.name == name) {
      return file.bytes;
    }
  }
  throw std::logic_error("no shader '" + std::string(name) + "' is built into the program");
}

/// The file with its includes expanded. GLSL has none.
std::string expandIncludes(std::string_view name) {
  constexpr std::string_view directive = "#include \"";
  std::string_view rest = shaderFile(name);
  std::string text;
  for (std::size_t at = rest.find(directive); at != std::string_view::npos; at = rest.find(directive)) {
    text += rest.substr(0, at);
    rest.remove_prefix(at + directive.size());
    const std::size_t end = rest.find('"');
    if (end == std::string_view::npos) {
      throw std::logic_error("shader '" + std::string(name) + "' has an #include without an end");
    }
    text += expandIncludes(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  text += rest;
  return text;
}

std::string shaderLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log;
}

std::string programLog(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  return log;
}

/// Compiles one stage and attaches it. The program keeps it alive.
void attachStage(GLuint program, GLenum stage, std::string_view name, std::string_view defines) {
  const std::string source = "#version 330 core\n" + std::string(defines) + expandIncludes(name);
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    const std::string log = shaderLog(shader);
    glDeleteShader(shader);
    throw std::logic_error("shader '" + std::string(name) + "' does not compile:\n" + log);
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

void linkProgram(GLuint program, std::string_view name) {
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    throw std::logic_error("the program of shader '" + std::string(name) + "' does not link:\n" + programLog(program));
  }
}

}  // namespace

ShaderProgram::ShaderProgram(std::string_view vertexFile, std::string_view fragmentFile, std::string_view geometryFile,
                             std::string_view defines)
    : program_(glCreateProgram()) {
  try {
    attachStage(program_, GL_VERTEX_SHADER, vertexFile, defines);
    attachStage(program_, GL_FRAGMENT_SHADER, fragmentFile, defines);
    if (!geometryFile.empty()) {
      attachStage(program_, GL_GEOMETRY_SHADER, geometryFile, defines);
    }
    linkProgram(program_, fragmentFile);
  } catch (...) {
    glDeleteProgram(program_);
    throw;
  }
  const GLuint block = glGetUniformBlockIndex(program_, "Frame");
  if (block != GL_INVALID_INDEX) {
    glUniformBlockBinding(program_, block, frameBlockBinding);
  }
}

ShaderProgram::~ShaderProgram() {
  glDeleteProgram(program_);
}

void ShaderProgram::use() const {
  glUseProgram(program_);
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(program_, uniform), value);
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  glUniform4fv(glGetUniformLocation(program_, uniform), 1, value.data());
}

}  // namespace drape::render
