#pragma once

#include <GL/glew.h>
#include <Eigen/Core>
#include <string>
#include <string_view>

namespace drape::render {

/// A linked shader program from the embedded files of shaders/. A line `#include "name"` in a shader includes that
/// file. Throws std::logic_error with the compiler's log on failure: shaders are part of the program, so this is a bug.
class ShaderProgram {
 public:
  /// `defines` is inserted at the top of every stage ("#define WIREFRAME\n"). An empty geometry name omits that stage.
  ShaderProgram(std::string_view vertexFile, std::string_view fragmentFile, std::string_view geometryFile = {},
                std::string_view defines = {});
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;
  ~ShaderProgram();

  void use() const;

  /// Sets a uniform of the current program. A uniform that the compiler removed is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;

 private:
  GLuint program_ = 0U;
};

/// The binding point of the uniform block "Frame" in every program.
inline constexpr GLuint frameBlockBinding = 0U;

}  // namespace drape::render
