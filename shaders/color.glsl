// Colours. Light is computed in linear units. Constants in the source are colours as they appear on the screen.

vec3 fromScreen(vec3 color) { return pow(color, vec3(2.2)); }

// Bright parts approach white gradually instead of being clipped, so that folds stay visible in full light.
vec3 toScreen(vec3 light) {
  const float bend = 0.55;
  vec3 over = max(light - bend, 0.0);
  vec3 soft = min(light, bend) + (1.0 - bend) * (1.0 - exp(-over / (1.0 - bend)));
  return pow(max(soft, 0.0), vec3(1.0 / 2.2));
}

// The studio's wall, as it appears on the screen: brightest behind the cloth, and darker towards the corners.
vec3 backdrop(vec2 pixel) {
  vec2 place = pixel * viewport.zw;
  vec2 fromGlow = (place - vec2(0.5, 0.58)) * vec2(0.85, 1.0);
  float glow = exp(-2.2 * dot(fromGlow, fromGlow));
  return mix(vec3(0.690, 0.714, 0.741), vec3(0.894, 0.902, 0.910), glow);
}

// Ordered dithering by less than one step of an 8-bit colour, in a pattern of 4 by 4 pixels. It hides the bands of a soft
// gradient. Unlike noise it hardly makes the file of a picture larger.
vec3 dither(vec2 pixel) {
  ivec2 p = ivec2(pixel);
  int coarse = ((p.x ^ p.y) & 1) * 2 + (p.y & 1);
  int fine = (((p.x ^ p.y) >> 1) & 1) * 2 + ((p.y >> 1) & 1);
  return vec3((float(coarse * 4 + fine) + 0.5) / 16.0 - 0.5) / 255.0;
}
