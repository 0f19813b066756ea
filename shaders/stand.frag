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

const vec3 paint = vec3(0.400, 0.415, 0.435);

void main() {
  vec3 toEye = normalize(eye.xyz - surface.position);
  vec3 normal = normalize(surface.normal);
  float visible = keyVisibility(surface.position, normal);
  float facing = dot(normal, toLight.xyz);
  vec3 light = keyLight * visible * max(facing, 0.0) + roomLight(normal, toEye, surface.curvature);
  float shine = pow(max(dot(normal, normalize(toLight.xyz + toEye)), 0.0), 60.0);
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 5.0);
  pixel = vec4(toScreen(fromScreen(paint) * light + shine * 0.25 * visible * keyLight + rim * 0.2 * skyLight), 1.0);
}
