uniform vec4 colour;  // as it appears on the screen

out vec4 pixel;

void main() {
  pixel = colour;
}
