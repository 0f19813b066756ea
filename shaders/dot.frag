// A disc with a light rim, so that it is visible on dark and on bright cloth.
uniform float size;  // [pixels]
uniform vec4 fill;   // as it appears on the screen

out vec4 pixel;

void main() {
  float away = length(gl_PointCoord - 0.5) * (size + 2.0);  // from the centre [pixels]
  float radius = 0.5 * size;
  float inside = 1.0 - smoothstep(radius - 0.6, radius + 0.4, away);
  float core = 1.0 - smoothstep(radius - 2.1, radius - 1.1, away);
  bool bright = dot(fill.rgb, vec3(0.3, 0.6, 0.1)) > 0.8;
  vec3 rim = bright ? vec3(0.96, 0.62, 0.16) : vec3(0.98);
  pixel = vec4(mix(rim, fill.rgb, core), inside * fill.a);
}
