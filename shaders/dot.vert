#include "frame.glsl"

uniform float size;  // [pixels]

layout(location = 0) in vec3 position;

void main() {
  // A little nearer than it is, so that the cloth it sits on does not cut it in half.
  gl_Position = viewProjection * vec4(mix(position, eye.xyz, 0.008), 1.0);
  gl_PointSize = size + 2.0;
}
