// Cloth with the look of its fabric.
#include "frame.glsl"
#include "color.glsl"
#include "light.glsl"
#include "noise.glsl"
#include "structure.glsl"
#ifdef WRINKLES
#include "wrinkles.glsl"
#endif

uniform vec2 warpTurn;       // cosine and sine of the angle by which warp is turned
uniform vec3 warpColor;      // as on the screen
uniform vec3 weftColor;      // as on the screen
uniform float roughness;     // slope of the microfacets along a yarn
uniform float anisotropy;    // by how much it is larger across a yarn
uniform float shine;         // reflectance, in units of a usual plastic's
uniform float sheen;         // brightness at a grazing view
uniform float translucency;  // fraction of the light that passes through

in Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
  vec2 yarns;
} surface;

out vec4 pixel;

// Along weft and warp, turned by the angle of warp [m].
vec2 placeOnFabric() {
  return vec2(dot(surface.yarns, warpTurn), dot(surface.yarns, vec2(-warpTurn.y, warpTurn.x)));
}

// The directions in which x and y grow on the cloth as it hangs.
Directions frameOf(vec2 place, vec3 normal) {
  vec3 positionX = dFdx(surface.position);
  vec3 positionY = dFdy(surface.position);
  vec2 placeX = dFdx(place);
  vec2 placeY = dFdy(place);
  float side = placeX.x * placeY.y - placeX.y * placeY.x < 0.0 ? -1.0 : 1.0;
  vec3 weft = side * (positionX * placeY.y - positionY * placeX.y);
  vec3 warp = side * (positionY * placeX.x - positionX * placeY.x);
  weft -= normal * dot(normal, weft);
  warp -= normal * dot(normal, warp);
  // Texture coordinates without area give no directions. Any two serve then.
  if (min(dot(weft, weft), dot(warp, warp)) < 1e-28) {
    weft = cross(abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), normal);
    warp = cross(normal, weft);
  }
  return Directions(weft * inversesqrt(max(dot(weft, weft), 1e-30)), warp * inversesqrt(max(dot(warp, warp), 1e-30)), normal);
}

// Fraction of the light that a surface of this reflectance reflects [Schlick 1994].
float fresnel(float cosine) { return 0.04 + 0.96 * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0); }

// Highlight of the key light: microfacets of the GGX distribution, wider across the yarns than along them [Burley 2012].
float highlight(Directions frame, vec3 normal, vec3 toEye, Yarn yarn) {
  vec3 middle = normalize(toLight.xyz + toEye);
  float across = roughness * (1.0 + anisotropy);
  vec2 width = mix(vec2(across, roughness), vec2(roughness, across), yarn.weft);  // along weft and warp
  width = min(sqrt(width * width * width * width + yarn.rough), 1.0);
  vec2 slope = vec2(dot(middle, frame.weft), dot(middle, frame.warp)) / width;
  float facing = max(dot(middle, normal), 0.0);
  float d = dot(slope, slope) + facing * facing;
  float facets = 1.0 / (width.x * width.y * d * d);
  float cosine = max(dot(middle, toLight.xyz), 0.1);
  return facets * fresnel(cosine) * max(dot(normal, toLight.xyz), 0.0) / (4.0 * cosine * cosine);
}

void main() {
  bool front = gl_FrontFacing;
  vec3 toEye = normalize(eye.xyz - eye.w * surface.position);
  vec3 smoothNormal = normalize(surface.normal) * (front ? 1.0 : -1.0);
  smoothNormal = normalize(smoothNormal + toEye * max(0.02 - dot(smoothNormal, toEye), 0.0));

  vec2 place = placeOnFabric();
  Directions frame = frameOf(place, smoothNormal);
  Yarn yarn = structureAt(place, frame, toEye, front);
#ifdef WRINKLES
  vec3 baseNormal = wrinkled(surface.position, smoothNormal, toEye, front);
#else
  vec3 baseNormal = smoothNormal;
#endif
  vec3 normal = normalize(baseNormal - yarn.slope.x * frame.weft - yarn.slope.y * frame.warp);
  frame.weft = normalize(frame.weft - normal * dot(normal, frame.weft));
  frame.warp = normalize(frame.warp - normal * dot(normal, frame.warp));

  // The back is a little duller.
  float side = front ? 1.0 : 0.6;
  // Dense warp yarns shade the weft between them.
  float shade = front && structure == 0 && weave.z < 1.0 ? 0.5 : 1.0;
  vec3 color = mix(fromScreen(warpColor), shade * fromScreen(weftColor), yarn.weft) * max(yarn.light, 0.0);
  float facing = dot(baseNormal, toLight.xyz);
  float visible = keyVisibility(surface.position, sideOfLight(smoothNormal));
  float lit = max((dot(normal, toLight.xyz) + 0.08) / 1.08, 0.0);
  vec3 through = 0.48 * translucency * max(-facing, 0.0) * sqrt(color);
  vec3 room = roomLight(surface.position, normal, toEye, front ? surface.curvature : -surface.curvature);
  vec3 result = color * (keyLight * visible * (lit + through) + room);

  float grazing = 1.0 - max(dot(baseNormal, toEye), 0.0);
  vec3 tint = mix(vec3(1.0), color / max(max(color.r, color.g), max(color.b, 1e-3)), 0.8);
  result += sheen * pow(grazing, 3.0) * tint * (room + 0.6 * keyLight * visible * max(facing + 0.3, 0.0));

  // Light that is reflected between fibres takes on their colour.
  vec3 gloss = side * shine * yarn.light * mix(vec3(1.0), tint, structure <= 2 ? 0.5 : 0.0);
  result += gloss * visible * keyLight * highlight(frame, normal, toEye, yarn);
  vec3 mirrored = reflect(-toEye, normal);
  vec3 around = mix(floorLight, skyLight, smoothstep(-0.6, 0.6, mirrored.y));
  result += gloss * (1.0 - roughness) * (1.0 - roughness) * fresnel(max(dot(normal, toEye), 0.0)) * around;
  pixel = vec4(toScreen(result), 1.0);
}
