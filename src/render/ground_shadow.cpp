#include "render/ground_shadow.hpp"

#include "render/texture_units.hpp"

#include <algorithm>

namespace drape::render {
namespace {

constexpr double penumbraRoom = 1.25;  // side of the square relative to the sharp shadow, for the penumbra [-]

void setUpTarget(GLuint texture, GLuint framebuffer) {
  constexpr int side = GroundShadow::resolution;
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, side, side, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  requireCompleteFramebuffer("the shadow on the ground");
}

}  // namespace

GroundShadow::GroundShadow()
    : gather_("fullscreen.vert", "ground_shadow.frag"), smooth_("fullscreen.vert", "ground_shadow_smooth.frag") {
  setUpTarget(rough_.name(), roughTarget_.name());
  setUpTarget(shadow_.name(), shadowTarget_.name());
}

void GroundShadow::fit(const ShadowMap& map, double groundHeight, const Eigen::Vector3d& toLight) {
  const double height = std::max(map.centre().y() - groundHeight, 0.0);
  const Eigen::Vector3d below = map.centre() - toLight * (height / toLight.y());
  centre_ = {below.x(), below.z()};
  halfSide_ = penumbraRoom * map.radius() / toLight.y();
}

void GroundShadow::draw() const {
  glViewport(0, 0, resolution, resolution);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(nothing_.name());

  glBindFramebuffer(GL_FRAMEBUFFER, roughTarget_.name());
  gather_.use();
  gather_.set("shadowMap", static_cast<int>(shadowUnit));
  gather_.set("shadowDepth", static_cast<int>(shadowDepthUnit));
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glBindFramebuffer(GL_FRAMEBUFFER, shadowTarget_.name());
  glActiveTexture(GL_TEXTURE0 + groundShadowUnit);
  glBindTexture(GL_TEXTURE_2D, rough_.name());
  smooth_.use();
  smooth_.set("rough", static_cast<int>(groundShadowUnit));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  checkGl("the shadow on the ground");
}

void GroundShadow::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, shadow_.name());
}

}  // namespace drape::render
