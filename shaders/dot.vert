#include "frame.glsl"

uniform float size;  // [pixels]

layout(location = 0) in vec3 position;

void main() {
  // Drawn slightly nearer, so that the cloth does not hide half of the dot.
  gl_Position = viewProjection * vec4(mix(position, eye.xyz + (1.0 - eye.w) * position, 0.008), 1.0);
  gl_PointSize = size + 2.0;
}
