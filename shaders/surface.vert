#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinate;

out Surface {
  vec3 position;    // [m]
  vec3 normal;
  vec2 coordinate;  // along the cloth [m]
} surface;

void main() {
  surface.position = position;
  surface.normal = normal;
  surface.coordinate = coordinate;
  gl_Position = viewProjection * vec4(position, 1.0);
}
