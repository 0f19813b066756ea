#include "figure/skeleton.hpp"
#include "io/garments/figure_solid.hpp"
#include "io/garments/garments.hpp"
#include "io/garments/implicit_solid.hpp"

#include <array>
#include <cmath>

namespace drape::io {
namespace {

using figure::Joint;
using figure::restOf;

/// Parts in metres, for x >= 0; the other side mirrors them. They leave about a centimetre to the sewn T-shirt. Its
/// front and back lie flat at the seams, so shoulders and arms must be slim.
const Ellipsoid head{{0.0, 1.632, 0.014}, {0.076, 0.112, 0.094}};
const TaperedBar neck{{0.0, 1.400, -0.004}, {0.0, 1.560, 0.008}, 0.048, 0.043};
const TaperedBar shoulder{{0.0, 1.394, 0.0}, {0.170, 1.374, 0.0}, 0.038, 0.035, 0.8};
const Ellipsoid chest{{0.0, 1.240, 0.0}, {0.172, 0.172, 0.080}};
const Ellipsoid waist{{0.0, 1.060, 0.0}, {0.122, 0.170, 0.068}};
const Ellipsoid hips{{0.0, 0.890, -0.004}, {0.166, 0.130, 0.080}};
const TaperedBar thigh{{0.078, 0.840, -0.002}, {0.080, 0.660, 0.0}, 0.080, 0.068, 0.88};
const TaperedBar upperArm{restOf(Joint::LeftUpperArm), restOf(Joint::LeftForearm), 0.039, 0.036, 0.64};
const TaperedBar forearm{restOf(Joint::LeftForearm), restOf(Joint::LeftHand), 0.035, 0.021, 0.8};
const TaperedBar hand{{0.610, 1.096, 0.032}, {0.672, 1.040, 0.040}, 0.027, 0.019, 0.6};
const TaperedBar pole{{0.0, 0.030, 0.0}, {0.0, 0.800, 0.0}, 0.019, 0.019};
constexpr double baseRadius = 0.180;
constexpr double baseHeight = 0.040;
constexpr double baseRounding = 0.019;

double distanceToBase(const Vec3& point) {
  const double beside = std::hypot(point.x(), point.z()) - (baseRadius - baseRounding);
  const double above = std::abs(point.y() - baseHeight / 2.0) - (baseHeight / 2.0 - baseRounding);
  return std::hypot(std::max(beside, 0.0), std::max(above, 0.0)) + std::min(std::max(beside, above), 0.0) -
         baseRounding;
}

}  // namespace

double distanceToFigure(const Vec3& point) {
  const Vec3 p(std::abs(point.x()), point.y(), point.z());
  double trunk = joined(distanceTo(chest, p), distanceTo(waist, p), 0.08);
  trunk = joined(trunk, distanceTo(hips, p), 0.09);
  trunk = joined(trunk, distanceTo(shoulder, p), 0.04);
  trunk = joined(trunk, distanceTo(thigh, p), 0.05);
  trunk = joined(trunk, distanceTo(neck, p), 0.03);
  trunk = joined(trunk, distanceTo(head, p), 0.03);
  double arm = joined(distanceTo(upperArm, p), distanceTo(forearm, p), 0.02);
  arm = joined(arm, distanceTo(hand, p), 0.02);
  return joined(trunk, arm, 0.02);
}

namespace {

double distanceToMannequin(const Vec3& p) {
  const double stand = joined(distanceTo(pole, p), distanceToBase(p), 0.03);
  return joined(distanceToFigure(p), stand, 0.018);
}

}  // namespace

RawMesh makeMannequin() {
  return surfaceOf(distanceToMannequin, {-0.756, -0.036, -0.216}, {0.756, 1.80, 0.216}, 0.018);
}

}  // namespace drape::io
