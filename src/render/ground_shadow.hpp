#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"

#include <Eigen/Core>

namespace drape::render {

/// The soft shadow on the ground; it is softer below higher objects. It is computed per texel of ground and only after
/// motion, so many samples are affordable at any picture size.
class GroundShadow {
 public:
  GroundShadow();

  /// Places the square of ground that can be in shadow. `groundHeight` in [m].
  void fit(const ShadowMap& map, double groundHeight, const Eigen::Vector3d& toLight);

  /// Computes the shadow. Needs a bound shadow map and an uploaded frame block. Leaves another framebuffer bound.
  void draw() const;

  /// Binds the result to a texture unit: 0 in the light, 1 in full shadow.
  void bind(GLuint unit) const;

  [[nodiscard]] const Eigen::Vector2d& centre() const { return centre_; }  ///< x and z [m]
  [[nodiscard]] double halfSide() const { return halfSide_; }              ///< [m]

  static constexpr int resolution = 256;  // [texels]

 private:
  ShaderProgram gather_;
  ShaderProgram smooth_;
  GlVertexArray nothing_;
  GlTexture rough_;
  GlTexture shadow_;
  GlFramebuffer roughTarget_;
  GlFramebuffer shadowTarget_;
  Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
  double halfSide_ = 1.0;
};

}  // namespace drape::render
