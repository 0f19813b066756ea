// The studio's light: a large key light from above, the bright room around it, and faint lights from
// the other side and from the viewer, so that no side of the cloth is flat.

uniform sampler2DShadow shadowMap;
uniform sampler2D occlusionMap;  // of occlusion_smooth.frag, coarser than the picture

const vec3 keyLight = vec3(1.00, 0.965, 0.92) * 0.95;
const vec3 skyLight = vec3(0.88, 0.94, 1.00) * 0.54;
const vec3 floorLight = vec3(1.00, 0.95, 0.90) * 0.34;
const vec3 counterLight = vec3(0.90, 0.95, 1.00) * 0.34;  // from the other side, without shadows
const vec3 toCounterLight = vec3(-0.54, 0.36, -0.76);
const float viewerLight = 0.12;

// The i-th of n points that fill the unit disc evenly (golden angle).
vec2 discPoint(int i, int n, float turn) {
  float angle = 2.39996323 * float(i) + turn;
  return sqrt((float(i) + 0.5) / float(n)) * vec2(cos(angle), sin(angle));
}

// The normal of a surface to the side of the key light.
vec3 sideOfLight(vec3 normal) { return dot(normal, toLight.xyz) >= 0.0 ? normal : -normal; }

// Fraction of the key light that reaches a point, 0 to 1. `normal` points to the side of the light.
float keyVisibility(vec3 position, vec3 normal) {
  if (toLight.w < 0.5) {
    return 1.0;
  }
  const int samples = 8;
  vec3 lifted = position + shadowScale.x * (1.5 * normal + 1.5 * toLight.xyz);
  vec3 place = (shadowFromWorld * vec4(lifted, 1.0)).xyz;
  float light = 0.0;
  for (int i = 0; i < samples; ++i) {
    light += texture(shadowMap, vec3(place.xy + 2.4 * shadowScale.z * discPoint(i, samples, 0.4), place.z));
  }
  return light / float(samples);
}

// Fraction of the room's light that reaches a point: less in a hollow, slightly more on a ridge. Folds as narrow as 10 cm
// have an effect. `curvature` is positive in a hollow [1/m].
float openness(float curvature) {
  float bend = 0.035 * curvature;
  return 1.0 - 0.75 * bend / (0.55 + abs(bend)) * (bend > 0.0 ? 1.0 : 0.35);
}

// Fraction of the room's light that reaches a point of this pixel past other surfaces: the mean of the four nearest places
// of the map, of which those on other surfaces do not count.
float unblocked(vec3 position) {
  if (occlusion.y < 0.5) {
    return 1.0;
  }
  float depth = depthAlongView(position);
  ivec2 last = textureSize(occlusionMap, 0) - 1;
  vec2 place = gl_FragCoord.xy * viewport.zw * vec2(last + 1) - 0.5;
  vec2 corner = floor(place);
  vec2 share = place - corner;
  float sum = 1e-3;
  float weights = 1e-3;
  for (int i = 0; i < 4; ++i) {
    ivec2 to = ivec2(i & 1, i >> 1);
    vec2 there = texelFetch(occlusionMap, clamp(ivec2(corner) + to, ivec2(0), last), 0).xy;
    vec2 near = mix(1.0 - share, share, vec2(to));
    float weight = near.x * near.y * sameSurface(there.y - depth);
    sum += weight * there.x;
    weights += weight;
  }
  return sum / weights;
}

// Ambient light.
vec3 roomLight(vec3 position, vec3 normal, vec3 toEye, float curvature) {
  vec3 room = mix(floorLight, skyLight, 0.5 + 0.5 * normal.y);
  room += counterLight * max(dot(normal, toCounterLight), 0.0) + viewerLight * max(dot(normal, toEye), 0.0);
  return room * openness(curvature) * unblocked(position);
}
