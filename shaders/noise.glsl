// Random numbers and smooth noise from positions, the same on every graphics card.

uint scrambled(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

// 0 to 1, for a cell of the plane.
float random(vec2 cell) {
  ivec2 c = ivec2(cell);
  return float(scrambled(uint(c.x) + scrambled(uint(c.y))) >> 8) / 16777216.0;
}

vec2 random2(vec2 cell) { return vec2(random(cell), random(cell + vec2(31.0, 177.0))); }

// Smooth noise with wavelengths of about 2. x: value, -1 to 1; yz: its derivative.
vec3 noise(vec2 x) {
  vec2 cell = floor(x);
  vec2 f = x - cell;
  vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = random(cell);
  float b = random(cell + vec2(1.0, 0.0));
  float c = random(cell + vec2(0.0, 1.0));
  float d = random(cell + vec2(1.0, 1.0));
  float across = a - b - c + d;
  float value = a + (b - a) * u.x + (c - a) * u.y + across * u.x * u.y;
  return vec3(2.0 * value - 1.0, 2.0 * du * (vec2(b - a, c - a) + across * u.yx));
}

// Visibility of a detail, 1 to 0, when a pixel covers `cycles` periods of it. It is 0 from half a period on, where the
// detail would alias.
float seen(float cycles) { return 1.0 - smoothstep(0.2, 0.5, cycles); }
vec2 seen(vec2 cycles) { return 1.0 - smoothstep(0.2, 0.5, cycles); }
