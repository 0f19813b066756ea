// The nearest surfaces as the viewer sees them.
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 seenNormal;  // along the width, the height and the depth of the picture
out float depth;      // depthAlongView

void main() {
  mat4 rows = transpose(viewProjection);
  vec3 forward = eye.w > 0.0 ? rows[3].xyz : normalize(rows[2].xyz);
  seenNormal = vec3(dot(normal, normalize(rows[0].xyz)), dot(normal, normalize(rows[1].xyz)), dot(normal, forward));
  depth = depthAlongView(position);
  gl_Position = viewProjection * vec4(position, 1.0);
}
