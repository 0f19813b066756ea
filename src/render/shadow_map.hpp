#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/smooth_mesh.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>

namespace drape::render {

/// The depth of the nearest surface along the parallel rays of the key light.
class ShadowMap {
 public:
  ShadowMap();

  /// Fits the map to the box of all objects that cast shadows. Its size changes in steps and its position in whole
  /// texels, so that shadows do not flicker while objects move.
  void fit(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& toLight);

  /// Draws the meshes into the map. Needs an uploaded frame block. Leaves another framebuffer bound.
  void draw(std::span<const SmoothMesh* const> meshes) const;

  /// Binds the map to two texture units: for comparisons (sampler2DShadow) and for its depths (sampler2D).
  void bind(GLuint comparingUnit, GLuint depthUnit) const;

  [[nodiscard]] const Eigen::Matrix4f& fromWorld() const { return fromWorld_; }
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }                        ///< [m]
  [[nodiscard]] double texelSize() const { return 2.0 * radius_ / resolution; }  ///< [m]

  static constexpr int resolution = 1024;  // [texels]

 private:
  ShaderProgram program_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
  GlSampler comparing_;
  GlSampler plain_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 1.0;
  Eigen::Matrix4f fromWorld_ = Eigen::Matrix4f::Identity();
};

}  // namespace drape::render
