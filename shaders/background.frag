#include "frame.glsl"
#include "color.glsl"

out vec4 pixel;

void main() {
  pixel = vec4(backdrop(gl_FragCoord.xy) + dither(gl_FragCoord.xy), 1.0);
}
