// Colours. Light is reckoned in linear units; what stands in the source is written as it appears on the screen.

vec3 fromScreen(vec3 color) { return pow(color, vec3(2.2)); }

// Bright parts bend towards white instead of being cut off, so that folds stay visible in full light.
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

// Less than one step of an 8-bit colour, in a fine fixed pattern: it breaks up the bands of a soft gradient.
vec3 dither(vec2 pixel) {
  return vec3((fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0);
}
