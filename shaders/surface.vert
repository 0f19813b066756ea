#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinate;
layout(location = 3) in float curvature;

out Surface {
  vec3 position;    // [m]
  vec3 normal;
  vec2 coordinate;  // along the cloth [m]
  float curvature;  // positive: hollow as seen from the front [1/m]
} surface;

void main() {
  surface.position = position;
  surface.normal = normal;
  surface.coordinate = coordinate;
  surface.curvature = curvature;
  gl_Position = viewProjection * vec4(position, 1.0);
}
