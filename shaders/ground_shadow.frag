// The shadow on one patch of ground. It first searches for things between the patch and the light. The penumbra that it
// averages then is wider, the higher these things are.
#include "frame.glsl"
#include "light.glsl"

uniform sampler2D shadowDepth;

in vec2 place;
out vec4 result;

const float keySize = 0.10;   // radius of the key light as seen from the ground, over its distance
const float roomSize = 0.75;  // the same for the bright part of the room
const int blockerSamples = 10;
const int samples = 16;

// Fraction of the light of a disc of that size that does not reach the ground.
float shadowOf(vec3 at, float size, float turn) {
  // The map is as deep as it is wide, so depths and widths are in the same unit.
  float reach = size * at.z;
  float depthSum = 0.0;
  float blockers = 0.0;
  for (int i = 0; i < blockerSamples; ++i) {
    float depth = texture(shadowDepth, at.xy + reach * discPoint(i, blockerSamples, turn)).r;
    if (depth < at.z - 0.002) {
      depthSum += depth;
      blockers += 1.0;
    }
  }
  if (blockers < 0.5) {
    return 0.0;
  }
  float penumbra = max(size * (at.z - depthSum / blockers), 1.5 * shadowScale.z);
  float light = 0.0;
  for (int i = 0; i < samples; ++i) {
    light += texture(shadowMap, vec3(at.xy + penumbra * discPoint(i, samples, turn), at.z - 0.002));
  }
  return 1.0 - light / float(samples);
}

void main() {
  vec2 patchCentre = groundShadow.xy + (2.0 * place - 1.0) * groundShadow.z;
  vec3 at = (shadowFromWorld * vec4(patchCentre.x, ground.y, patchCentre.y, 1.0)).xyz;
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
  // The ground may lie below the depth range of the map. The penumbra still depends on the ground's own depth.
  float shadow = 0.75 * shadowOf(at, keySize, turn) + 0.25 * shadowOf(at, roomSize, turn);
  result = vec4(shadow);
}
