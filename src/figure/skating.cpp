#include "figure/leg.hpp"
#include "figure/motions.hpp"
#include "figure/periodic_curve.hpp"

#include <cmath>
#include <numbers>

namespace drape::figure {
namespace {

double sideways(double phase) {
  return std::sin(2.0 * std::numbers::pi * phase);
}

double alternating(double phase) {
  return std::cos(2.0 * std::numbers::pi * phase);
}

/// The curves of a foot over the period. At 0 it takes the weight and glides, at 0.5 it has pushed off to its side, and
/// then it comes back behind the other leg.
struct StrokeCurves {
  PeriodicCurve out;     ///< to its side from the middle of the body [m]
  PeriodicCurve ahead;   ///< of its place in the rest pose [m]
  PeriodicCurve height;  ///< of the ball above its rest position [m]
  PeriodicCurve yaw;     ///< outwards [degrees]
  PeriodicCurve pitch;   ///< toes up [degrees]
};

const StrokeCurves& strokeCurves() {
  static const StrokeCurves curves{
      PeriodicCurve({{0.0, 0.07},
                     {0.12, 0.06},
                     {0.25, 0.10},
                     {0.38, 0.24},
                     {0.50, 0.40},
                     {0.60, 0.40},
                     {0.75, 0.22},
                     {0.90, 0.10}}),
      PeriodicCurve({{0.0, 0.04},
                     {0.12, 0.06},
                     {0.25, 0.04},
                     {0.38, -0.04},
                     {0.50, -0.16},
                     {0.62, -0.30},
                     {0.78, -0.22},
                     {0.90, -0.04}}),
      PeriodicCurve(
          {{0.0, 0.0}, {0.12, 0.0}, {0.25, 0.0}, {0.38, 0.0}, {0.48, 0.005}, {0.60, 0.10}, {0.75, 0.09}, {0.90, 0.03}}),
      PeriodicCurve({{0.0, 4.0}, {0.25, 8.0}, {0.40, 20.0}, {0.52, 28.0}, {0.70, 16.0}, {0.88, 4.0}}),
      PeriodicCurve({{0.0, 0.0}, {0.15, 0.0}, {0.40, 0.0}, {0.50, -8.0}, {0.62, -26.0}, {0.78, -14.0}, {0.92, 0.0}})};
  return curves;
}

FootPlace strokeAt(const Vec3& rest, Side side, double phase) {
  const StrokeCurves& curves = strokeCurves();
  const double out = side == Side::Left ? 1.0 : -1.0;
  FootPlace foot;
  foot.ball = Vec3(out * curves.out.at(phase), rest.y() + curves.height.at(phase), rest.z() + curves.ahead.at(phase));
  foot.yaw = out * curves.yaw.at(phase);
  foot.pitch = curves.pitch.at(phase);
  return foot;
}

}  // namespace

FigurePose skate(const PerJoint<Vec3>& places, double phase) {
  // The left foot glides in the first half of the period, the right one in the second.
  constexpr double lean = 30.0;  // of the trunk, forwards [degrees]
  FigurePose pose;
  const double left = sideways(phase);  // 1: the weight is on the left foot
  const double turn = alternating(phase + 0.08);
  pose.shift = Vec3(0.07 * sideways(phase - 0.03), -0.105 - 0.018 * alternating(2.0 * phase - 0.25), -0.06);
  pose.rotation(Joint::Hips) =
      turned(7.0 * turn, Vec3::UnitY()) * turned(-5.0 * left, Vec3::UnitZ()) * turned(0.55 * lean, Vec3::UnitX());
  for (const Joint joint : {Joint::Spine, Joint::Chest}) {
    pose.rotation(joint) =
        turned(-8.0 * turn, Vec3::UnitY()) * turned(2.0 * left, Vec3::UnitZ()) * turned(0.225 * lean, Vec3::UnitX());
  }
  pose.rotation(Joint::Neck) = turned(4.0 * turn, Vec3::UnitY()) * turned(-0.35 * lean, Vec3::UnitX());
  pose.rotation(Joint::Head) = turned(5.0 * turn, Vec3::UnitY()) * turned(-0.40 * lean, Vec3::UnitX());
  // Each arm swings against the leg of its side.
  placeArm(Side::Left, 30.0, 14.0 - 38.0 * turn, 34.0 - 14.0 * turn, pose);
  placeArm(Side::Right, 30.0, 14.0 + 38.0 * turn, 34.0 + 14.0 * turn, pose);
  placeFoot(places, Side::Left, strokeAt(places[indexOf(Joint::LeftToes)], Side::Left, phase), pose);
  placeFoot(places, Side::Right, strokeAt(places[indexOf(Joint::RightToes)], Side::Right, fractionOf(phase + 0.5)),
            pose);
  return pose;
}

}  // namespace drape::figure
