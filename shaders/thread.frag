uniform float width;   // [pixels]
uniform vec4 colour;   // as it appears on the screen

in float across;
out vec4 pixel;

void main() {
  float inside = 1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, abs(across));
  pixel = vec4(colour.rgb, colour.a * inside);
}
