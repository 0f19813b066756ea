#include "frame.glsl"

out vec3 position;  // [m]

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  position = vec3(ground.x + corner.x * ground.w, ground.y, ground.z + corner.y * ground.w);
  gl_Position = viewProjection * vec4(position, 1.0);
}
