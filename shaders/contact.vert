// The two ends of the line that marks a contact: from its point along its normal.
#include "frame.glsl"

layout(location = 0) in vec3 position;

void main() {
  // Drawn slightly nearer, so that the cloth does not hide the start of the line.
  gl_Position = viewProjection * vec4(mix(position, eye.xyz + (1.0 - eye.w) * position, 0.004), 1.0);
}
