#include "frame.glsl"

uniform float size;  // [pixels]

layout(location = 0) in vec3 position;

void main() {
  gl_Position = viewProjection * vec4(position, 1.0);
  // A little nearer than it is, so that the cloth it sits on does not cut it in half.
  gl_Position.z -= 0.004 * gl_Position.w;
  gl_PointSize = size + 2.0;
}
