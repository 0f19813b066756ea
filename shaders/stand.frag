#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"

in Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
  vec2 yarns;
} surface;

out vec4 pixel;

#ifdef BODY
const vec3 paint = vec3(0.560, 0.500, 0.590);
const vec3 otherPaint = vec3(0.430, 0.370, 0.470);  // of every second sector of a round object
#else
const vec3 paint = vec3(0.400, 0.415, 0.435);
#endif

vec3 paintHere() {
#ifdef BODY
  float wave = surface.coordinate.x;
  float edge = max(fwidth(wave), 1e-4);
  return mix(fromScreen(paint), fromScreen(otherPaint), smoothstep(-edge, edge, wave));
#else
  return fromScreen(paint);
#endif
}

void main() {
  vec3 toEye = normalize(eye.xyz - eye.w * surface.position);
  vec3 normal = normalize(surface.normal);
  float visible = keyVisibility(surface.position, normal);
  float facing = dot(normal, toLight.xyz);
  vec3 light = keyLight * visible * max(facing, 0.0) + roomLight(surface.position, normal, toEye, surface.curvature);
  float shine = pow(max(dot(normal, normalize(toLight.xyz + toEye)), 0.0), 60.0);
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 5.0);
  pixel = vec4(toScreen(paintHere() * light + shine * 0.25 * visible * keyLight + rim * 0.2 * skyLight), 1.0);
}
