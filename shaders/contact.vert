// The two ends of the line that stands where the cloth touches something.
#include "frame.glsl"

layout(location = 0) in vec3 position;

void main() {
  // A little nearer than it is, so that the cloth does not hide the line's foot.
  gl_Position = viewProjection * vec4(mix(position, eye.xyz, 0.004), 1.0);
}
