// The uniforms of a picture that all shaders share. src/render/frame_uniforms.hpp has the same fields. Lengths in metres.
layout(std140) uniform Frame {
  mat4 viewProjection;
  mat4 shadowFromWorld;  // to [0, 1] in each coordinate of the shadow map
  vec4 eye;              // in homogeneous coordinates; w is 0 for an orthographic view
  vec4 toLight;          // xyz: unit vector; w: 1 with shadows, 0 without
  vec4 viewport;         // width, height, and one over each [pixels]
  vec4 ground;           // xyz: centre; w: radius at which it has faded away
  vec4 groundShadow;     // xy: centre (x and z); z: half the side
  vec4 shadowScale;      // x: a texel's side, y: depth range, z: one over the number of texels
};
