#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"

in Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
} surface;

out vec4 pixel;

const vec3 clay = vec3(0.700, 0.690, 0.680);

void main() {
  vec3 toEye = normalize(eye.xyz - surface.position);
  vec3 normal = normalize(surface.normal);
  float facing = dot(normal, toLight.xyz);
  vec3 light = keyLight * keyVisibility(surface.position, normal) * max(facing, 0.0) + roomLight(normal, toEye, surface.curvature);
  pixel = vec4(toScreen(fromScreen(clay) * light), 1.0);
}
