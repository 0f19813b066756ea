// Removes the grain that the turned sampling pattern leaves: a tent of 7 by 7 patches.
uniform sampler2D rough;

in vec2 place;
out vec4 result;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(rough, 0));
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -3; y <= 3; ++y) {
    for (int x = -3; x <= 3; ++x) {
      float weight = (4.0 - abs(float(x))) * (4.0 - abs(float(y)));
      sum += weight * texture(rough, place + vec2(x, y) * texel).r;
      weights += weight;
    }
  }
  result = vec4(sum / weights);
}
