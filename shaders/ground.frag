// The floor: a pool of light that fades into the backdrop, with a fine grid in metres.
#include "frame.glsl"
#include "color.glsl"

uniform sampler2D groundShadowMap;

in vec3 position;
out vec4 pixel;

const vec3 floorColor = vec3(0.905, 0.908, 0.910);
const vec3 shadowColor = vec3(0.27, 0.31, 0.37);

// Fraction of the pixel that lies on lines of a grid with this spacing [m]; lines are about a pixel wide.
float gridLines(vec2 x, vec2 width, float spacing) {
  vec2 w = width / spacing;
  vec2 away = abs(fract(x / spacing - 0.5) - 0.5) / max(w, 1e-6);  // [pixels]
  vec2 line = (1.0 - smoothstep(0.3, 1.2, away)) * (1.0 - smoothstep(0.08, 0.35, w));
  return max(line.x, line.y);
}

void main() {
  float radius = length(position.xz - ground.xz) / ground.w;
  float present = 1.0 - smoothstep(0.10, 1.0, radius);
  vec2 width = fwidth(position.xz);

  vec3 color = mix(backdrop(gl_FragCoord.xy), floorColor, present * present);
  float lines = 0.10 * gridLines(position.xz, width, 1.0) + 0.030 * gridLines(position.xz, width, 0.1);
  color *= 1.0 - lines * present;

  vec2 place = (position.xz - groundShadow.xy) / groundShadow.z;
  float shadow = texture(groundShadowMap, 0.5 + 0.5 * place).r;
  shadow *= toLight.w * (1.0 - smoothstep(0.85, 1.0, max(abs(place.x), abs(place.y))));
  color = mix(color, color * shadowColor, 0.62 * shadow * sqrt(present));
  pixel = vec4(color + dither(gl_FragCoord.xy), 1.0);
}
