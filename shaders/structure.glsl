// The structure of a fabric: colours, and a normal map in which every yarn is round. Each part fades to its mean before
// it becomes smaller than a pixel, so that there is no moire. Lengths in yarns: x counts columns (warp yarns or wales),
// y counts rows (weft yarns or courses).

uniform int structure;      // Structure in src/fabrics/look.hpp
uniform vec3 weave;         // repeat, step, weft on top
uniform vec2 count;         // columns and rows a metre
uniform float relief;       // steepest slope of a yarn's side
uniform float unevenness;   // of the yarns' brightness

// Unit vectors.
struct Directions {
  vec3 weft;
  vec3 warp;
  vec3 normal;  // to the visible side
};

struct Yarn {
  vec2 slope;   // of the surface, along x and y, towards the viewer
  float weft;   // fraction of the weft's colour, 0 to 1
  float light;  // brightness: less between yarns; 1 on average
  float rough;  // mean square of the slopes that are too small to be seen
};

const float pi = 3.14159265;

// Mean over a width of the pulse that is 1 for fract(x) < duty.
float meanPulse(float x, float duty, float width) {
  float w = max(width, 1e-3);
  vec2 ends = fract(x) + 0.5 * vec2(-w, w);
  vec2 integral = floor(ends) * duty + min(fract(ends), duty);
  return (integral.y - integral.x) / w;
}

// Fraction of the front that the weft covers. `diagonal`: the change of p.y - p.x over a pixel.
float weftShare(vec2 p, vec2 w, float diagonal) {
  float repeat = weave.x;
  float mean = weave.z / repeat;
  // Near: the weft crosses each column at different rows. Dense warp yarns leave rounded gaps in which the weft shows.
  float across = 2.0 * fract(p.x) - 1.0;
  float gap = weave.z < 1.0 ? mean * (1.15 - 0.45 * across * across) : mean;
  float row = p.y - mod(floor(p.x) * weave.y, repeat) - 0.5 * weave.z;
  float near = meanPulse(row / repeat + 0.5 * gap, gap, w.y / repeat);
  near = mix(mean, near, seen(w.x) * seen(w.y / repeat));
  if (weave.y != 1.0 || repeat < 3.0) {
    return near;
  }
  // Farther away: the diagonal ribs of a twill are wider than its yarns.
  float width = diagonal / repeat;
  float ribs = meanPulse((p.y - p.x + 0.5) / repeat, mean, width);
  ribs = mix(mean, ribs, seen(width));
  return mix(ribs, near, seen(w.x));
}

// Brightness of single yarns, and of parts where they are thicker: x for warp, y for weft. 0 on average.
vec2 yarnBrightness(vec2 p, vec2 w) {
  vec2 single = 2.0 * vec2(random(vec2(floor(p.x), 7.0)), random(vec2(floor(p.y), 11.0))) - 1.0;
  vec2 thick = vec2(noise(vec2(p.x, p.y / 90.0)).x, noise(vec2(p.x / 90.0 + 17.0, p.y)).x);
  vec2 bundle = vec2(noise(vec2(p.x / 5.0, p.y / 260.0)).x, noise(vec2(p.x / 260.0, p.y / 5.0 + 40.0)).x);
  return seen(w) * (0.5 * single + 0.5 * thick) + vec2(0.6, 0.3) * seen(w / 10.0) * bundle;
}

// A yarn consists of twisted fibres, which are visible from very near.
float fibres(vec2 across, vec2 along, float weft, vec2 w) {
  float warpFibres = sin(2.0 * pi * (2.0 * across.x + 1.5 * along.y)) * seen(2.0 * w.x + 1.5 * w.y);
  float weftFibres = sin(2.0 * pi * (2.0 * across.y - 1.5 * along.x)) * seen(2.0 * w.y + 1.5 * w.x);
  return mix(warpFibres, weftFibres, weft);
}

Yarn woven(vec2 p, vec2 w, float diagonal, bool front) {
  float weft = weftShare(p, w, diagonal);
  weft = front ? weft : 1.0 - weft;
  vec2 across = 2.0 * fract(p) - 1.0;  // from one side of the yarn to the other: -1 to 1
  float repeat = weave.x;
  float phase = mod(p.y - floor(p.x) * weave.y, repeat);
  float over = front ? (phase - weave.z) / (repeat - weave.z) : phase / weave.z;
  float dive = clamp(2.0 * over - 1.0, -1.0, 1.0);  // of the warp, which goes down at both ends of its float
  vec2 warpSlope = -relief * vec2(across.x, 0.8 * dive * dive * dive);
  vec2 weftSlope = -relief * vec2(0.8 * across.x * across.x * across.x, across.y);
  vec2 a4 = across * across * across * across;
  float d4 = dive * dive * dive * dive;
  float gaps = mix(0.45 * a4.x + 0.25 * d4, 0.45 * a4.y + 0.25 * a4.x, weft);
  vec2 visible = seen(w);
  float both = visible.x * visible.y;
  vec2 brightness = yarnBrightness(p, w);
  Yarn yarn;
  yarn.slope = mix(warpSlope, weftSlope, weft) * visible;
  yarn.weft = weft;
  yarn.light = 1.0 + (0.14 - gaps) * both + unevenness * mix(brightness.x, brightness.y, weft) +
               0.10 * fibres(across, p, weft, w);
  yarn.rough = 0.3 * relief * relief * (1.0 - both);
  return yarn;
}

// The front of a knit: every stitch shows two legs, which form a V.
Yarn stitches(vec2 p, vec2 w) {
  float side = fract(p.x) < 0.5 ? -1.0 : 1.0;
  float a = abs(2.0 * fract(p.x) - 1.0);  // 0 in the middle of the wale, 1 at its border
  float across = 2.0 * a - 1.0;
  float along = 2.0 * fract(p.y - 0.9 * a) - 1.0;
  float end = along * along * along;
  vec2 visible = seen(vec2(2.5, 1.5) * w);
  float both = visible.x * visible.y;
  Yarn yarn;
  yarn.slope = -relief * vec2(side * (across - 0.5 * end), 0.8 * end) * visible;
  yarn.weft = 0.0;
  float gaps = 0.45 * pow(across, 4.0) + 0.55 * along * end;
  float fibre = sin(2.0 * pi * (1.5 * along + side * across)) * seen(6.0 * max(w.x, w.y));
  yarn.light = 1.0 + (0.20 - gaps) * both + 0.08 * fibre;
  yarn.rough = 0.3 * relief * relief * (1.0 - both);
  return yarn;
}

// The back of a knit: rows of bumps.
Yarn purls(vec2 p, vec2 w) {
  float row = 2.0 * p.y + 0.35 * cos(2.0 * pi * p.x);
  float across = 2.0 * fract(row) - 1.0;
  float visible = seen(3.0 * w.y) * seen(1.5 * w.x);
  float bump = cos(2.0 * pi * p.x + (mod(floor(row), 2.0) < 0.5 ? 0.0 : pi));
  Yarn yarn;
  yarn.slope = -relief * vec2(0.6 * sin(2.0 * pi * p.x), across) * visible;
  yarn.weft = 1.0;
  yarn.light = 1.0 + (0.09 - 0.45 * pow(across, 4.0) + 0.12 * bump) * visible;
  yarn.rough = 0.3 * relief * relief * (1.0 - visible);
  return yarn;
}

Yarn knitted(vec2 p, vec2 w, bool front) {
  Yarn yarn = front ? stitches(p, w) : purls(p, w);
  float single = 2.0 * random(vec2(floor(p.y), 5.0)) - 1.0;
  float bundle = noise(vec2(p.x / 200.0, p.y / 4.0)).x;
  yarn.light += unevenness * (0.5 * seen(w.y) * single + 0.6 * seen(w.y / 8.0) * bundle);
  return yarn;
}

// Matted fibres: noise of all sizes.
Yarn matted(vec2 p, vec2 w, bool front) {
  Yarn yarn = Yarn(vec2(0.0), front ? 0.0 : 1.0, 1.0, 0.0);
  float size = 1.0;
  float wide = max(w.x, w.y);
  float share = 1.0;
  for (int octave = 0; octave < 6; ++octave) {
    vec3 n = noise(p / size + 19.0 * float(octave));
    float visible = seen(0.7 * wide / size);
    yarn.slope -= 0.4 * share * relief * visible * n.yz;
    yarn.light += 0.5 * share * unevenness * visible * n.x;
    yarn.rough += 0.05 * relief * relief * (1.0 - visible);
    size *= 2.0;
    share *= 0.7;
  }
  return yarn;
}

// Leather: round pebbles between creases.
Yarn grained(vec2 p, vec2 w) {
  vec2 place = p + 0.2 * noise(p / 5.0).yz;
  vec2 cell = floor(place);
  vec2 nearest = vec2(0.0);
  vec2 distances = vec2(8.0);  // squared, to the nearest and the second nearest centre
  for (int k = 0; k < 9; ++k) {
    vec2 other = cell + vec2(k % 3 - 1, k / 3 - 1);
    vec2 away = place - other - 0.15 - 0.7 * random2(other);
    float d = dot(away, away);
    nearest = d < distances.x ? away : nearest;
    distances = d < distances.x ? vec2(d, distances.x) : vec2(distances.x, min(distances.y, d));
  }
  float wide = max(w.x, w.y);
  float visible = seen(wide);
  float border = 1.0 - smoothstep(0.0, 0.3 + wide, sqrt(distances.y) - sqrt(distances.x));
  vec3 wrinkle = noise(p / 7.0);
  Yarn yarn;
  yarn.slope = -relief * (visible * nearest * (0.8 + 0.8 * border) + 0.05 * seen(wide / 8.0) * wrinkle.yz);
  yarn.weft = 0.0;
  yarn.light = 1.0 + visible * (0.10 - 0.35 * border) + 0.5 * unevenness * seen(wide / 8.0) * wrinkle.x;
  yarn.rough = 0.25 * relief * relief * (1.0 - visible);
  return yarn;
}

// The change over a pixel of a value with this gradient [1/m]. On tilted cloth it is large along the line of sight. It
// follows from the smooth normal, so it has no steps between triangles. Where a triangle is tilted much more than the
// smooth normal, the triangle's own normal counts.
float reach(vec3 gradient, float value, vec3 normal, vec3 toEye) {
  float focal = length(vec3(viewProjection[0][1], viewProjection[1][1], viewProjection[2][1]));  // in half heights
  float pixel = 2.0 / (gl_FragCoord.w * viewport.y * focal);                                     // [m]
  vec3 tilt = toEye / max(dot(normal, toEye), 0.02) - normal;
  float smoothly = pixel * length(vec2(length(gradient), dot(gradient, tilt)));
  return max(smoothly, 0.6 * length(vec2(dFdx(value), dFdy(value))));
}

// @param place along weft and warp [m]  @param frame see fabric.frag
Yarn structureAt(vec2 place, Directions frame, vec3 toEye, bool front) {
  vec2 p = place * count;
  vec3 alongX = frame.weft * count.x;
  vec3 alongY = frame.warp * count.y;
  vec2 w = vec2(reach(alongX, p.x, frame.normal, toEye), reach(alongY, p.y, frame.normal, toEye));
  float diagonal = reach(alongY - alongX, p.y - p.x, frame.normal, toEye);
  Yarn yarn = Yarn(vec2(0.0), front ? 0.0 : 1.0, 1.0, 0.0);
  if (structure == 0) {
    yarn = woven(p, w, diagonal, front);
  } else if (structure == 1) {
    yarn = knitted(p, w, front);
  } else if (structure == 2 || (structure == 3 && !front)) {
    yarn = matted(p, w, front);  // the back of leather is suede
  } else if (structure == 3) {
    yarn = grained(p, w);
  }
  return yarn;
}
