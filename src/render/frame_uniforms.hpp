#pragma once

#include "render/gl_objects.hpp"

#include <Eigen/Core>

namespace drape::render {

/// The data of a picture for all shaders: the block "Frame" of shaders/frame.glsl, member by member (std140).
struct FrameUniforms {
  Eigen::Matrix4f viewProjection;
  Eigen::Matrix4f shadowFromWorld;  ///< to [0, 1] in each coordinate of the shadow map
  Eigen::Vector4f eye;              ///< xyz [m]
  Eigen::Vector4f toLight;          ///< xyz: unit vector; w: 1 with shadows, 0 without
  Eigen::Vector4f viewport;         ///< width, height, and one over each [pixels]
  Eigen::Vector4f ground;           ///< centre [m] and the radius at which it has faded out [m]
  Eigen::Vector4f groundShadow;     ///< centre x and z, half the side [m], 0
  Eigen::Vector4f shadowScale;      ///< a texel's side and the depth range [m], one over the number of texels, 0
  Eigen::Vector4f occlusion;  ///< radius [m]; 1 with it, 0 without; half the picture's extents [m], at a depth of 1 m
};

/// The uniform block on the graphics card.
class FrameBlock {
 public:
  FrameBlock();
  void upload(const FrameUniforms& uniforms);

 private:
  GlBuffer buffer_;
};

}  // namespace drape::render
