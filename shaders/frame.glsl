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
  vec4 occlusion;        // x: distance up to which surfaces take light from each other; y: 1 with it, 0 without;
                         // zw: half the picture's width and height, for perspective at a depth of 1
};

// Depth of a point along the view: from the viewer, or for an orthographic view up to a constant [m].
float depthAlongView(vec3 point) {
  mat4 rows = transpose(viewProjection);
  vec4 clip = vec4(point, 1.0);
  return eye.w > 0.0 ? dot(rows[3], clip) : dot(rows[2], clip) / length(rows[2].xyz);
}

// How much a place of the occlusion map counts at another one with this difference of depthAlongView, 1 to 0.
float sameSurface(float difference) { return max(1.0 - 4.0 * abs(difference) / occlusion.x, 0.0); }
