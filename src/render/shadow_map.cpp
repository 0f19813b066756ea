#include "render/shadow_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::render {
namespace {

constexpr double radiusStep = 1.25;  // the map grows and shrinks by this factor [-]

/// Rows: right, up and towards the light.
Eigen::Matrix3d lightAxes(const Eigen::Vector3d& toLight) {
  const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(toLight).normalized();
  Eigen::Matrix3d axes;
  axes.row(0) = right;
  axes.row(1) = toLight.cross(right);
  axes.row(2) = toLight;
  return axes;
}

void setUpSampler(GLuint sampler, GLint filter, GLint compare) {
  constexpr std::array<float, 4> farAway{1.0F, 1.0F, 1.0F, 1.0F};
  glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
  glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, farAway.data());
  glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, compare);
  glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

}  // namespace

ShadowMap::ShadowMap() : program_("shadow.vert", "shadow.frag") {
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  setUpSampler(comparing_.name(), GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE);
  setUpSampler(plain_.name(), GL_NEAREST, GL_NONE);

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  requireCompleteFramebuffer("shadows");
}

void ShadowMap::fit(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& toLight) {
  const double needed = std::max(0.5 * box.diagonal().norm(), 0.01);
  radius_ = std::pow(radiusStep, std::ceil(std::log(1.02 * needed) / std::log(radiusStep)));
  const Eigen::Matrix3d axes = lightAxes(toLight);
  Eigen::Vector3d centre = axes * box.center();
  centre = (centre / texelSize()).array().round() * texelSize();
  centre_ = axes.transpose() * centre;

  // From the box [-radius, radius]^3 around the centre to [0, 1]^3; depth grows away from the light.
  const Eigen::Vector3d scale(0.5 / radius_, 0.5 / radius_, -0.5 / radius_);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = scale.asDiagonal() * axes;
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d::Constant(0.5) - scale.cwiseProduct(centre);
  fromWorld_ = matrix.cast<float>();
}

void ShadowMap::draw(std::span<const SmoothMesh* const> meshes) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, resolution, resolution);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glClear(GL_DEPTH_BUFFER_BIT);
  program_.use();
  for (const SmoothMesh* mesh : meshes) {
    mesh->draw();
  }
  checkGl("the shadow map");
}

void ShadowMap::bind(GLuint comparingUnit, GLuint depthUnit) const {
  glActiveTexture(GL_TEXTURE0 + comparingUnit);
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  glBindSampler(comparingUnit, comparing_.name());
  glActiveTexture(GL_TEXTURE0 + depthUnit);
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  glBindSampler(depthUnit, plain_.name());
}

}  // namespace drape::render
