#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"
#ifdef WRINKLES
#include "noise.glsl"
#include "wrinkles.glsl"
#endif

uniform float checkSize;  // side of a check [m]
uniform float checkered;  // 1: checks; 0: plain
uniform float ghostly;    // 1: the second cloth, which is green on both sides
uniform float shadowed;   // 1: shadows fall on it
uniform float opacity;

in Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
  vec2 yarns;
} surface;
#ifdef WIREFRAME
in vec3 barycentric;
#endif

#ifdef FIELD
uniform vec3 colours[11];  // as they appear on the screen, at equal distances from 0 to 1
#ifdef WIREFRAME
in float place;
#define fieldPlace place
#else
in float fieldPlace;
#endif
#endif

out vec4 pixel;

const vec3 frontLight = vec3(0.905, 0.885, 0.840);
const vec3 frontDark = vec3(0.255, 0.420, 0.560);
const vec3 backLight = vec3(0.900, 0.845, 0.790);
const vec3 backDark = vec3(0.770, 0.450, 0.350);
const vec3 frontPlain = vec3(0.300, 0.470, 0.600);
const vec3 frontWire = vec3(0.660, 0.745, 0.810);  // under the edges, so that they are visible
const vec3 backWire = vec3(0.880, 0.730, 0.660);
const vec3 backPlain = vec3(0.800, 0.520, 0.420);
const vec3 ghostFrontLight = vec3(0.800, 0.900, 0.760);
const vec3 ghostFrontDark = vec3(0.130, 0.560, 0.300);
const vec3 ghostBackLight = vec3(0.860, 0.890, 0.700);
const vec3 ghostBackDark = vec3(0.470, 0.580, 0.160);

// Mean over a pixel of the square wave that is +1 on even checks and -1 on odd ones. The wave's integral is a triangle
// wave, so the mean is a difference of two of its values: exact, and flat grey where checks are smaller than pixels.
vec2 meanSquareWave(vec2 x, vec2 width) {
  vec2 w = max(width, 1e-4);
  vec2 low = 1.0 - abs(2.0 * fract(0.5 * x - 0.25 * w) - 1.0);
  vec2 high = 1.0 - abs(2.0 * fract(0.5 * x + 0.25 * w) - 1.0);
  return (high - low) / w;
}

// Fraction of the pixel that light checks cover, 0 to 1.
float checks(vec2 coordinate) {
  vec2 x = coordinate / checkSize;
  vec2 wave = meanSquareWave(x, fwidth(x));
  return 0.5 + 0.5 * wave.x * wave.y;
}

// The threads of a plain weave, in which warp and weft alternate on top. They fade out before they would alias.
float weave(vec2 coordinate) {
  const float threads = 700.0;  // a metre
  const float pi = 3.14159265;
  vec2 x = coordinate * threads;
  vec2 w = fwidth(x);
  float visible = 1.0 - smoothstep(0.12, 0.40, max(w.x, w.y));
  vec2 ridge = 0.5 + 0.5 * cos(2.0 * pi * x);
  float warpOnTop = 0.5 + 0.5 * cos(pi * x.x) * cos(pi * x.y);
  return 1.0 + visible * 0.16 * (mix(ridge.y, ridge.x, warpOnTop) - 0.5);
}

// Colour of the cloth itself, linear.
vec3 clothColor(bool front) {
  vec3 light = front ? frontLight : backLight;
  vec3 dark = front ? frontDark : backDark;
  vec3 plain = front ? frontPlain : backPlain;
  if (ghostly > 0.5) {
    light = front ? ghostFrontLight : ghostBackLight;
    dark = front ? ghostFrontDark : ghostBackDark;
    plain = dark;
  }
  vec3 pattern = mix(fromScreen(dark), fromScreen(light), checks(surface.coordinate));
  return mix(fromScreen(plain), pattern, checkered) * weave(surface.coordinate);
}

#ifdef FIELD
// Colour of the field, as it appears on the screen. Grey where the field is not defined.
vec3 fieldColor() {
  if (fieldPlace < -1000.0) {
    return vec3(0.55);
  }
  float at = clamp(fieldPlace, 0.0, 1.0) * 10.0;
  int below = min(int(at), 9);
  return mix(colours[below], colours[below + 1], at - float(below));
}
#endif

#ifdef WIREFRAME
// Fraction of the pixel that edges cover. Edges fade where triangles are only a few pixels large, so that the cloth does
// not become dark there.
float edges() {
  vec3 width = max(fwidth(barycentric), vec3(1e-6));
  vec3 away = barycentric / width;  // [pixels]
  float nearest = min(away.x, min(away.y, away.z));
  float height = 1.0 / max(width.x, max(width.y, width.z));  // of the triangle [pixels]
  return (1.0 - smoothstep(0.25, 1.15, nearest)) * clamp((height - 1.0) / 5.0, 0.25, 1.0);
}
#endif

void main() {
  bool front = gl_FrontFacing;
  vec3 toEye = normalize(eye.xyz - eye.w * surface.position);
  vec3 smoothNormal = normalize(surface.normal) * (front ? 1.0 : -1.0);
  // At an outline a smooth normal may point away from the viewer. Turn it back to the visible side.
  smoothNormal = normalize(smoothNormal + toEye * max(0.02 - dot(smoothNormal, toEye), 0.0));
#ifdef WRINKLES
  vec3 normal = wrinkled(surface.position, smoothNormal, toEye, front);
#else
  vec3 normal = smoothNormal;
#endif

  vec3 color = clothColor(front);
#ifdef WIREFRAME
  vec3 wire = front ? frontWire : backWire;
  if (ghostly > 0.5) {
    wire = front ? ghostFrontLight : ghostBackLight;
  }
  color = mix(color, fromScreen(wire), 0.72);
#endif
  float facing = dot(normal, toLight.xyz);
  float visible = mix(1.0, keyVisibility(surface.position, sideOfLight(smoothNormal)), shadowed);
  float lit = max((facing + 0.08) / 1.08, 0.0);
  // Thin cloth lets light from behind through, in its own colour.
  vec3 through = 0.48 * max(-facing, 0.0) * sqrt(color);
  vec3 light = keyLight * visible * (lit + through) + roomLight(surface.position, normal, toEye, front ? surface.curvature : -surface.curvature);

  // Fibres on the surface reflect light at a grazing view, and the threads are slightly glossy.
  float fuzz = pow(1.0 - max(dot(normal, toEye), 0.0), 4.0);
  float shine = pow(max(dot(normal, normalize(toLight.xyz + toEye)), 0.0), 22.0);
  vec3 result = color * light + fuzz * 0.14 * skyLight + shine * 0.05 * visible * keyLight;

#ifdef FIELD
  // Light only darkens a little, so that the colours are those of the legend.
  float bright = clamp(dot(light, vec3(0.3, 0.6, 0.1)), 0.0, 1.0);
  vec3 shown = fieldColor() * mix(0.68, 1.0, bright);
#ifdef WIREFRAME
  shown = mix(shown, vec3(0.10, 0.13, 0.17), 0.6 * edges());
#endif
  pixel = vec4(shown, opacity);
#else
#ifdef WIREFRAME
  result = mix(result, vec3(0.010, 0.016, 0.026), 0.85 * edges());
#endif
  pixel = vec4(toScreen(result), opacity);
#endif
}
