// A straight line between two points, as a strip of constant width on the screen.
#include "frame.glsl"

layout(location = 0) in vec3 from;  // [m]
layout(location = 1) in vec3 to;    // [m]

uniform float width;  // [pixels]

out float across;  // from the middle [pixels]

void main() {
  vec4 a = viewProjection * vec4(from, 1.0);
  vec4 b = viewProjection * vec4(to, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport.xy;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  across = side * (0.5 * width + 1.0);
  gl_Position = gl_VertexID < 2 ? a : b;
  gl_Position.xy += vec2(-along.y, along.x) * across * 2.0 * viewport.zw * gl_Position.w;
}
