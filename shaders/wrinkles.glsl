// Wrinkles that are smaller than the triangles: a normal map, whose slopes follow the compression of the cloth
// (src/render/wrinkles.hpp). Needs noise.glsl. The waves are a sum of plane waves with the same direction, each with its
// own origin at a place of a lattice, as in phasor noise [Tricard et al. 2019, Procedural phasor noise]. The lattice is
// fixed to the cloth at rest, and the waves are even about their origins. So the wrinkles do not swim, and do not depend
// on the sign of their direction.

in vec3 wrinklePlace;     // in the mesh at rest, in wavelengths
in vec3 wrinkleDiagonal;  // xx, yy, zz of a tensor along the cloth: its trace is the square of the steepest slope, and
                          // the wrinkles run across its principal direction
in vec3 wrinkleMixed;     // yz, zx, xy

const float cellSize = 2.0;  // of the lattice, in wavelengths
// A rotation without symmetry, so that no plane of the lattice lies along the cloth.
const mat3 latticeTurn = mat3(0.5003, 0.8437, 0.1943, -0.5916, 0.1691, 0.7883, 0.6322, -0.5094, 0.5838);

// Where the wave of a lattice point has its origin, from the point, in cells.
vec3 originAt(ivec3 point) {
  uint bits = scrambled(uint(point.x) + scrambled(uint(point.y) + scrambled(uint(point.z))));
  return (vec3(bits & 1023u, (bits >> 10) & 1023u, (bits >> 20) & 1023u) / 1023.0 - 0.5) / cellSize;
}

// The slope of the waves across their crests, with a mean square of 1/2. `across`: unit vector.
float slopeOfWaves(vec3 place, vec3 across) {
  const float fullTurn = 6.28318531;
  vec3 x = latticeTurn * place / cellSize;
  vec3 cell = floor(x);
  vec3 f = x - cell;
  vec3 u = f * f * (3.0 - 2.0 * f);
  vec3 wave = fullTurn * cellSize * (latticeTurn * across);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec3 to = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 near = mix(1.0 - u, u, vec3(to));
    float phase = dot(wave, f - vec3(to) - originAt(ivec3(cell) + to));
    sum += near.x * near.y * near.z * vec2(cos(phase), sin(phase));
  }
  // Crests end where the sum is 0, with a slope that has no step. The factor gives the mean square of a sine, 1/2, to waves
  // of independent phases.
  return -1.2 * sum.y / (length(sum) + 0.1);
}

mat3 wrinkleTensor() {
  return mat3(wrinkleDiagonal.x, wrinkleMixed.z, wrinkleMixed.y, wrinkleMixed.z, wrinkleDiagonal.y, wrinkleMixed.x, wrinkleMixed.y,
              wrinkleMixed.x, wrinkleDiagonal.z);
}

// The principal direction of the tensor, a unit vector. Across the cloth the tensor is 0, so its principal values follow
// from its trace and its squares. With the smaller one b, the columns of T T - b T are along the direction of the larger.
vec3 acrossCrests() {
  mat3 tensor = wrinkleTensor();
  float trace = wrinkleDiagonal.x + wrinkleDiagonal.y + wrinkleDiagonal.z;
  float squares = dot(wrinkleDiagonal, wrinkleDiagonal) + 2.0 * dot(wrinkleMixed, wrinkleMixed);
  float smaller = 0.5 * (trace - sqrt(max(2.0 * squares - trace * trace, 0.0)));
  mat3 columns = tensor * tensor - smaller * tensor;
  vec3 lengths = vec3(dot(columns[0], columns[0]), dot(columns[1], columns[1]), dot(columns[2], columns[2]));
  vec3 longest = lengths.x > max(lengths.y, lengths.z) ? columns[0] : lengths.y > lengths.z ? columns[1] : columns[2];
  return longest * inversesqrt(max(dot(longest, longest), 1e-30));
}

// The normal with wrinkles, turned back to the visible side where it would point away. `normal`: unit vector to that side.
vec3 wrinkled(vec3 position, vec3 normal, vec3 toEye, bool front) {
  vec3 positionX = dFdx(position);
  vec3 positionY = dFdy(position);
  vec3 placeX = dFdx(wrinklePlace);
  vec3 placeY = dFdy(wrinklePlace);
  float squaredSlope = wrinkleDiagonal.x + wrinkleDiagonal.y + wrinkleDiagonal.z;
  if (squaredSlope < 1e-5) {
    return normal;
  }
  vec3 across = acrossCrests();
  vec2 change = vec2(dot(across, placeX), dot(across, placeY));
  // The direction on the cloth as it hangs in which the waves advance.
  vec3 alongX = cross(positionY, normal);
  vec3 alongY = cross(normal, positionX);
  vec3 uphill = (dot(positionX, alongX) < 0.0 ? -1.0 : 1.0) * (change.x * alongX + change.y * alongY);
  uphill *= inversesqrt(max(dot(uphill, uphill), 1e-30));
  // Smaller waves on the large ones. The squares of their slopes add up, as the lengths that they take up do.
  float cycles = length(change);
  float slope = sqrt(min(squaredSlope, 1.0)) * (0.9 * seen(cycles) * slopeOfWaves(wrinklePlace, across) +
                                                0.436 * seen(2.0 * cycles) * slopeOfWaves(2.0 * wrinklePlace + 11.3, across));
  vec3 result = normalize(normal - (front ? slope : -slope) * uphill);
  return normalize(result + toEye * max(0.02 - dot(result, toEye), 0.0));
}
