// Averages the pattern of 4 by 4 pixels in the samples of occlusion.frag, over pixels of the same surface.
#include "frame.glsl"

uniform sampler2D rough;

out vec4 result;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(rough, 0) - 1;
  float away = texelFetch(rough, here, 0).y;
  float sum = 0.0;
  float weights = 1e-6;
  for (int y = -2; y <= 1; ++y) {
    for (int x = -2; x <= 1; ++x) {
      vec2 there = texelFetch(rough, clamp(here + ivec2(x, y), ivec2(0), last), 0).xy;
      float weight = sameSurface(there.y - away);
      sum += weight * there.x;
      weights += weight;
    }
  }
  result = vec4(sum / weights, away, 0.0, 0.0);
}
