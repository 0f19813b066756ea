#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"

#include <Eigen/Core>

namespace drape {

/// The shadow on the ground, as soft as the thing that throws it is high. It is computed per patch of ground and only
/// when something has moved, so it can afford many samples whatever the size of the picture.
class GroundShadow {
 public:
  GroundShadow();

  /// Lays the square of ground that can be in shadow. `groundHeight` in [m].
  void fit(const ShadowMap& map, double groundHeight, const Eigen::Vector3d& toLight);

  /// Computes the shadow. Needs the shadow map bound and the frame block uploaded. Leaves another framebuffer bound.
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

}  // namespace drape
