#include "io/garments/garments.hpp"
#include "io/garments/implicit_solid.hpp"

#include <array>

namespace drape::io {
namespace {

/// Parts in metres. The figure faces and glides towards +z on its right leg (x < 0), with the left leg stretched
/// behind.
const Ellipsoid head{{0.0, 1.575, 0.160}, {0.074, 0.110, 0.094}};
const TaperedBar neck{{0.0, 1.380, 0.085}, {0.0, 1.520, 0.135}, 0.052, 0.044};
const TaperedBar shoulders{{-0.175, 1.350, 0.085}, {0.175, 1.350, 0.085}, 0.054, 0.054};
const Ellipsoid chest{{0.0, 1.210, 0.060}, {0.165, 0.180, 0.098}};
const Ellipsoid waist{{0.0, 1.030, 0.005}, {0.130, 0.160, 0.085}};
const Ellipsoid hips{{0.0, 0.870, -0.045}, {0.165, 0.120, 0.105}};
constexpr double fillet = 0.05;  // between these parts [m]

/// Limbs from the trunk outwards. Each bar begins at the end of the previous one.
const std::array<std::array<TaperedBar, 3>, 4> limbs = {{
    {{{{-0.090, 0.830, -0.040}, {-0.100, 0.500, 0.150}, 0.088, 0.060},
      {{-0.100, 0.500, 0.150}, {-0.100, 0.130, -0.020}, 0.056, 0.044},
      {{-0.100, 0.058, -0.050}, {-0.100, 0.055, 0.160}, 0.047, 0.043}}},
    {{{{0.090, 0.830, -0.040}, {0.115, 0.490, -0.110}, 0.088, 0.060},
      {{0.115, 0.490, -0.110}, {0.170, 0.170, -0.400}, 0.056, 0.044},
      {{0.168, 0.140, -0.440}, {0.215, 0.057, -0.270}, 0.045, 0.041}}},
    {{{{-0.190, 1.340, 0.090}, {-0.300, 1.095, 0.165}, 0.048, 0.040},
      {{-0.300, 1.095, 0.165}, {-0.240, 0.985, 0.370}, 0.039, 0.030},
      {{-0.240, 0.985, 0.370}, {-0.225, 0.990, 0.440}, 0.034, 0.030}}},
    {{{{0.190, 1.340, 0.090}, {0.320, 1.105, 0.155}, 0.048, 0.040},
      {{0.320, 1.105, 0.155}, {0.390, 0.930, 0.300}, 0.039, 0.030},
      {{0.390, 0.930, 0.300}, {0.405, 0.905, 0.365}, 0.034, 0.030}}},
}};

double distanceToSkater(const Vec3& p) {
  double solid = joined(distanceTo(chest, p), distanceTo(waist, p), fillet);
  solid = joined(solid, distanceTo(hips, p), fillet);
  solid = joined(solid, distanceTo(shoulders, p), fillet);
  solid = joined(solid, distanceTo(neck, p), fillet);
  solid = joined(solid, distanceTo(head, p), 0.03);
  for (const auto& limb : limbs) {
    const double lower = joined(distanceTo(limb[1], p), distanceTo(limb[2], p), 0.03);
    solid = joined(solid, joined(distanceTo(limb[0], p), lower, 0.03), 0.03);
  }
  return solid;
}

}  // namespace

RawMesh makeSkater() {
  // With this origin the surface crosses no cell twice.
  return surfaceOf(distanceToSkater, {-0.420, -0.016, -0.546}, {0.480, 1.740, 0.540}, 0.025);
}

}  // namespace drape::io
