#include "figure/skeleton.hpp"
#include "io/garments/figure_solid.hpp"
#include "io/garments/garments.hpp"
#include "io/garments/implicit_solid.hpp"

#include <cmath>

namespace drape::io {
namespace {

using figure::Joint;
using figure::restOf;

/// The legs for x >= 0; the other side mirrors them.
const TaperedBar upperLeg{{0.078, 0.840, -0.002}, restOf(Joint::LeftShin), 0.080, 0.050};
const TaperedBar calf{restOf(Joint::LeftShin) - Vec3(0.0, 0.06, 0.016), {0.090, 0.250, -0.010}, 0.050, 0.041};
const TaperedBar lowerLeg{restOf(Joint::LeftShin), restOf(Joint::LeftFoot), 0.049, 0.034};
const TaperedBar heel{{0.091, 0.042, -0.040}, {0.095, 0.036, 0.040}, 0.039, 0.036};
const TaperedBar instep{restOf(Joint::LeftFoot), restOf(Joint::LeftToes), 0.036, 0.032};
const TaperedBar toes{restOf(Joint::LeftToes), {0.099, 0.030, 0.140}, 0.032, 0.026};

/// They make the mannequin's flat forearm and hand rounder: flat parts as thin as a cell would be jagged.
const TaperedBar roundForearm{restOf(Joint::LeftForearm), restOf(Joint::LeftHand), 0.033, 0.025};
const TaperedBar roundHand{restOf(Joint::LeftHand), {0.668, 1.044, 0.040}, 0.027, 0.023};

double distanceToLowerArm(const Vec3& p) {
  return joined(distanceTo(roundForearm, p), distanceTo(roundHand, p), 0.02);
}

double distanceToLeg(const Vec3& p) {
  double leg = joined(distanceTo(upperLeg, p), distanceTo(lowerLeg, p), 0.03);
  leg = joined(leg, distanceTo(calf, p), 0.04);
  double foot = joined(distanceTo(heel, p), distanceTo(instep, p), 0.03);
  foot = joined(foot, distanceTo(toes, p), 0.03);
  return joined(leg, foot, 0.03);
}

double distanceToWhole(const Vec3& point) {
  const Vec3 p(std::abs(point.x()), point.y(), point.z());
  return joined(joined(distanceToFigure(p), distanceToLeg(p), 0.02), distanceToLowerArm(p), 0.02);
}

}  // namespace

RawMesh makeFigure() {
  // With this origin and this cell the surface crosses no cell twice.
  return surfaceOf(distanceToWhole, {-0.828, -0.031, -0.211}, {0.828, 1.80, 0.216}, 0.023);
}

}  // namespace drape::io
