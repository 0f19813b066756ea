#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/smooth_mesh.hpp"

#include <span>

namespace drape::render {

/// How much of the room's light surfaces take from each other, as far as the picture shows them: a map of half the
/// picture's width and height, computed from the depth and the normals of the nearest surfaces (McGuire, Mara and
/// Luebke 2012, "Scalable ambient obscurance").
class AmbientOcclusion {
 public:
  /// Computes the map for a picture of that size [pixels]. Needs an uploaded frame block. Leaves another framebuffer
  /// bound.
  void draw(std::span<const SmoothMesh* const> meshes, int width, int height);

  /// Binds the map to a texture unit.
  void bind(GLuint unit) const;

 private:
  void allocate(int width, int height);
  void drawSurfaces(std::span<const SmoothMesh* const> meshes) const;

  ShaderProgram surfaceProgram_{"occlusion_surface.vert", "occlusion_surface.frag"};
  ShaderProgram gather_{"fullscreen.vert", "occlusion.frag"};
  ShaderProgram smooth_{"fullscreen.vert", "occlusion_smooth.frag"};
  GlVertexArray nothing_;
  GlRenderbuffer nearest_;
  GlTexture depths_;
  GlTexture normals_;
  GlTexture rough_;
  GlTexture map_;
  GlFramebuffer surfaceTarget_;
  GlFramebuffer roughTarget_;
  GlFramebuffer mapTarget_;
  int width_ = 0;   // of the map [texels]
  int height_ = 0;  // of the map [texels]
};

}  // namespace drape::render
