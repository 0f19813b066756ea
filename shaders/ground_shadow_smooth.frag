// Removes the grain that the rotated sampling pattern leaves, by a tent filter of 6 by 6 patches. Each read returns the
// mean of four patches.
uniform sampler2D rough;

in vec2 place;
out vec4 result;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(rough, 0));
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      float weight = (2.0 - abs(float(x))) * (2.0 - abs(float(y)));
      sum += weight * texture(rough, place + (2.0 * vec2(x, y) + 0.5) * texel).r;
    }
  }
  result = vec4(sum / 16.0);
}
