#pragma once

#include <GL/glew.h>
#include <Eigen/Core>
#include <string>
#include <string_view>

namespace drape {

/// A linked shader program made from the embedded files of shaders/. A line `#include "name"` in a shader stands for
/// that file. Throws std::logic_error with the compiler's log when one does not compile: shaders are part of the
/// program, so that is a defect, not bad input.
class ShaderProgram {
 public:
  /// `defines` is put at the top of every stage ("#define WIREFRAME\n"). An empty geometry name leaves that stage out.
  ShaderProgram(std::string_view vertexFile, std::string_view fragmentFile, std::string_view geometryFile = {},
                std::string_view defines = {});
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;
  ~ShaderProgram();

  void use() const;

  /// Set a uniform of the program in use. A uniform that the compiler has removed is ignored.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;

 private:
  GLuint program_ = 0U;
};

/// Uniform block "Frame" is read from this binding point by every program that declares it.
inline constexpr GLuint frameBlockBinding = 0U;

}  // namespace drape
