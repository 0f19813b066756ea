#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinate;
layout(location = 3) in float curvature;
layout(location = 4) in vec2 yarns;
#ifdef FIELD
layout(location = 5) in float place;
#endif
#ifdef WRINKLES
layout(location = 6) in vec3 placeOfWrinkles;
layout(location = 7) in vec3 diagonalOfWrinkles;
layout(location = 8) in vec3 mixedOfWrinkles;
#endif

out Surface {
  vec3 position;    // [m]
  vec3 normal;
  vec2 coordinate;  // along the cloth [m]
  float curvature;  // positive: hollow as seen from the front [1/m]
  vec2 yarns;       // along weft and warp at rest [m]
} surface;
#ifdef FIELD
out float fieldPlace;  // in the range of colours, 0 to 1; below -1000 where the field is not defined
#endif
#ifdef WRINKLES
out vec3 wrinklePlace;  // see wrinkles.glsl
out vec3 wrinkleDiagonal;
out vec3 wrinkleMixed;
#endif

void main() {
  surface.position = position;
  surface.normal = normal;
  surface.coordinate = coordinate;
  surface.curvature = curvature;
  surface.yarns = yarns;
#ifdef FIELD
  fieldPlace = place;
#endif
#ifdef WRINKLES
  wrinklePlace = placeOfWrinkles;
  wrinkleDiagonal = diagonalOfWrinkles;
  wrinkleMixed = mixedOfWrinkles;
#endif
  gl_Position = viewProjection * vec4(position, 1.0);
}
