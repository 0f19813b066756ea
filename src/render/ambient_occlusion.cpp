#include "render/ambient_occlusion.hpp"

#include "render/texture_units.hpp"

#include <algorithm>
#include <array>

namespace drape::render {
namespace {

constexpr int coarseness = 2;    // pixels of the picture for each texel of the map, in both directions
constexpr float farAway = 1e5F;  // depth without a surface [m]

/// A texture without filters, into which a framebuffer draws.
void setUpTarget(GLuint framebuffer, GLenum attachment, GLuint texture, GLint format, int width, int height) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
}

/// Fills a framebuffer by a program that reads a texture as `input`.
void fill(const ShaderProgram& program, GLuint framebuffer, const char* input, GLuint texture) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glActiveTexture(GL_TEXTURE0 + occlusionUnit);
  glBindTexture(GL_TEXTURE_2D, texture);
  program.use();
  program.set(input, static_cast<int>(occlusionUnit));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

void AmbientOcclusion::allocate(int width, int height) {
  width_ = width;
  height_ = height;
  glBindRenderbuffer(GL_RENDERBUFFER, nearest_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, surfaceTarget_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, nearest_.name());
  setUpTarget(surfaceTarget_.name(), GL_COLOR_ATTACHMENT0, depths_.name(), GL_R32F, width, height);
  setUpTarget(surfaceTarget_.name(), GL_COLOR_ATTACHMENT1, normals_.name(), GL_RGBA8, width, height);
  constexpr std::array<GLenum, 2> outputs{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
  requireCompleteFramebuffer("ambient occlusion");
  setUpTarget(roughTarget_.name(), GL_COLOR_ATTACHMENT0, rough_.name(), GL_RG32F, width, height);
  requireCompleteFramebuffer("ambient occlusion");
  setUpTarget(mapTarget_.name(), GL_COLOR_ATTACHMENT0, map_.name(), GL_RG32F, width, height);
  requireCompleteFramebuffer("ambient occlusion");
}

void AmbientOcclusion::drawSurfaces(std::span<const SmoothMesh* const> meshes) const {
  glBindFramebuffer(GL_FRAMEBUFFER, surfaceTarget_.name());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearColor(farAway, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  surfaceProgram_.use();
  for (const SmoothMesh* mesh : meshes) {
    mesh->draw();
  }
}

void AmbientOcclusion::draw(std::span<const SmoothMesh* const> meshes, int width, int height) {
  const int halfWidth = std::max((width + coarseness - 1) / coarseness, 1);
  const int halfHeight = std::max((height + coarseness - 1) / coarseness, 1);
  if (halfWidth != width_ || halfHeight != height_) {
    allocate(halfWidth, halfHeight);
  }
  glViewport(0, 0, width_, height_);
  drawSurfaces(meshes);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(nothing_.name());
  gather_.use();
  gather_.set("normals", static_cast<int>(normalsUnit));
  glActiveTexture(GL_TEXTURE0 + normalsUnit);
  glBindTexture(GL_TEXTURE_2D, normals_.name());
  fill(gather_, roughTarget_.name(), "depths", depths_.name());
  fill(smooth_, mapTarget_.name(), "rough", rough_.name());
  glBindVertexArray(0);
  checkGl("ambient occlusion");
}

void AmbientOcclusion::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, map_.name());
}

}  // namespace drape::render
