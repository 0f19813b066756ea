// Fraction of the room's light that reaches each point of the picture past the surfaces around it [McGuire, Mara and
// Luebke 2012, "Scalable ambient obscurance"]. It needs only the nearest surfaces and their normals.
#include "frame.glsl"

uniform sampler2D depths;   // of occlusion_surface.frag
uniform sampler2D normals;  // likewise

out vec4 result;  // x: the fraction; y: the depth

const int samples = 10;
const float turns = 3.0;      // of the spiral of samples
const float strength = 2.2;   // how much light surfaces take from each other
const float bias = 0.02;      // of the radius; smaller steps do not count, such as those between flat triangles
const float widest = 0.12;    // largest radius of the samples, in heights of the picture
const float farAway = 1e4;    // deeper than any surface [m]

// The point of the surface there, in the coordinates of the view [m].
vec3 positionAt(ivec2 texel) {
  float depth = texelFetch(depths, clamp(texel, ivec2(0), textureSize(depths, 0) - 1), 0).r;
  vec2 across = (2.0 * vec2(texel) + 1.0) / vec2(textureSize(depths, 0)) - 1.0;
  return vec3(across * occlusion.zw * (eye.w > 0.0 ? depth : 1.0), depth);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 here = positionAt(at);
  if (here.z > farAway) {
    result = vec4(1.0, here.z, 0.0, 0.0);
    return;
  }
  vec3 normal = normalize(texelFetch(normals, at, 0).xyz - 0.5);

  float radius = occlusion.x;
  float height = float(textureSize(depths, 0).y);
  float reach = height * min(0.5 * radius / (occlusion.w * (eye.w > 0.0 ? here.z : 1.0)), widest);
  // A pattern of 4 by 4 pixels, which occlusion_smooth.frag averages.
  ivec2 cell = at & 3;
  float turn = 6.2831853 * float(4 * (cell.y ^ cell.x) + cell.x) / 16.0;
  float taken = 0.0;
  for (int i = 0; i < samples; ++i) {
    float share = (float(i) + 0.5) / float(samples);
    float angle = turn + 6.2831853 * turns * share;
    vec3 way = positionAt(at + ivec2(round(reach * share * vec2(cos(angle), sin(angle))))) - here;
    float squared = dot(way, way);
    float near = max(1.0 - squared / (radius * radius), 0.0);
    taken += near * near * near * max(dot(way, normal) - bias * radius, 0.0) / (squared + 1e-4 * radius * radius);
  }
  result = vec4(max(1.0 - strength * radius * taken / float(samples), 0.0), here.z, 0.0, 0.0);
}
