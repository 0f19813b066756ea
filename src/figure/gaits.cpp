#include "figure/gaits.hpp"

#include "figure/leg.hpp"
#include "figure/motions.hpp"
#include "figure/periodic_curve.hpp"

#include <cmath>
#include <numbers>

namespace drape::figure {
namespace {

/// The curves of a foot over the period, which begins when its heel meets the ground.
struct FootCurves {
  PeriodicCurve pitch;   ///< toes up [degrees]
  PeriodicCurve height;  ///< of the ball above its rest position [m]
  PeriodicCurve toes;    ///< up, relative to the foot [degrees]
};

/// How far the trunk and the arms turn [degrees].
struct TrunkSwing {
  double hipsYaw;
  double hipsList;  ///< the hip of the free leg falls
  double chestYaw;  ///< against the hips
  double armForward;
  double armBack;
  double armLower;
  double elbow;
  double elbowSwing;  ///< the elbow bends more in front
};

const FootCurves& walkCurves() {
  static const FootCurves curves{
      PeriodicCurve({{0.0, 17.0},
                     {0.05, 8.0},
                     {0.11, 0.0},
                     {0.24, 0.0},
                     {0.38, -2.0},
                     {0.50, -18.0},
                     {0.62, -50.0},
                     {0.70, -48.0},
                     {0.80, -14.0},
                     {0.90, 10.0},
                     {0.96, 18.0}}),
      PeriodicCurve({{0.0, 0.041},
                     {0.05, 0.020},
                     {0.11, 0.0},
                     {0.24, 0.0},
                     {0.38, 0.0},
                     {0.50, 0.0},
                     {0.60, 0.004},
                     {0.70, 0.050},
                     {0.80, 0.045},
                     {0.90, 0.050},
                     {0.96, 0.050}}),
      PeriodicCurve({{0.0, 4.0}, {0.11, 0.0}, {0.38, 2.0}, {0.50, 17.0}, {0.60, 34.0}, {0.72, 14.0}, {0.86, 4.0}})};
  return curves;
}

const FootCurves& runCurves() {
  static const FootCurves curves{
      PeriodicCurve({{0.0, 8.0},
                     {0.07, 0.0},
                     {0.18, -4.0},
                     {0.28, -26.0},
                     {0.36, -52.0},
                     {0.50, -78.0},
                     {0.62, -62.0},
                     {0.78, -16.0},
                     {0.92, 8.0}}),
      PeriodicCurve({{0.0, 0.022},
                     {0.07, 0.0},
                     {0.18, 0.0},
                     {0.28, 0.0},
                     {0.36, 0.030},
                     {0.50, 0.260},
                     {0.62, 0.290},
                     {0.78, 0.190},
                     {0.92, 0.085}}),
      PeriodicCurve({{0.0, 4.0}, {0.07, 0.0}, {0.18, 4.0}, {0.30, 30.0}, {0.42, 18.0}, {0.62, 4.0}, {0.85, 4.0}})};
  return curves;
}

constexpr TrunkSwing walkSwing{5.0, 3.0, 10.0, 24.0, 22.0, 44.0, 20.0, 10.0};
constexpr TrunkSwing runSwing{8.0, 3.0, 18.0, 36.0, 42.0, 40.0, 78.0, 12.0};

double wave(double phase) {
  return std::cos(2.0 * std::numbers::pi * phase);
}

/// How far a ball is before the middle of its way, as a share of the stride. The ground carries it backwards at a
/// constant speed; then a cubic Hermite curve with the same speed at both ends brings it forward.
double ballAhead(const Gait& gait, double phase) {
  const double p = fractionOf(phase);
  const double reach = 0.5 * gait.stance;
  if (p <= gait.stance) {
    return reach - p;
  }
  const double length = 1.0 - gait.stance;
  const double s = (p - gait.stance) / length;
  return -reach + s * s * (3.0 - 2.0 * s) * 2.0 * reach - length * s * (1.0 - s) * (1.0 - 2.0 * s);
}

FootPlace footAt(const Gait& gait, const FootCurves& curves, const Vec3& rest, double phase) {
  FootPlace foot;
  foot.pitch = curves.pitch.at(phase);
  foot.toes = curves.toes.at(phase);
  foot.ball = rest;
  foot.ball.x() *= 0.80;  // the feet come closer to the line of the way than at rest
  foot.ball.y() += curves.height.at(phase);
  foot.ball.z() = gait.ahead + gait.stride * ballAhead(gait, phase);
  return foot;
}

void swingTrunk(const Gait& gait, const TrunkSwing& swing, double phase, FigurePose& pose) {
  // At phase 0 the left foot is in front: the left hip is in front, and the right arm.
  const double leading = wave(phase - 0.02);
  const double leftStance = wave(phase - 0.5 * gait.stance);
  pose.shift = Vec3(gait.sway * leftStance, -gait.drop - gait.bob * wave(2.0 * (phase - gait.bobPhase)), 0.0);
  pose.rotation(Joint::Hips) = turned(-swing.hipsYaw * leading, Vec3::UnitY()) *
                               turned(swing.hipsList * leftStance, Vec3::UnitZ()) *
                               turned(0.5 * gait.lean, Vec3::UnitX());
  const double counter = 0.5 * (swing.hipsYaw + swing.chestYaw) * leading;
  for (const Joint joint : {Joint::Spine, Joint::Chest}) {
    pose.rotation(joint) = turned(counter, Vec3::UnitY()) * turned(-0.6 * swing.hipsList * leftStance, Vec3::UnitZ()) *
                           turned(0.25 * gait.lean, Vec3::UnitX());
  }
  pose.rotation(Joint::Neck) =
      turned(-0.5 * swing.chestYaw * leading, Vec3::UnitY()) * turned(-0.4 * gait.lean, Vec3::UnitX());
  pose.rotation(Joint::Head) =
      turned(-0.5 * swing.chestYaw * leading, Vec3::UnitY()) * turned(-0.5 * gait.lean, Vec3::UnitX());
  for (const Side side : {Side::Left, Side::Right}) {
    const double forward = side == Side::Left ? -wave(phase - 0.04) : wave(phase - 0.04);
    const double mean = 0.5 * (swing.armForward - swing.armBack);
    const double amplitude = 0.5 * (swing.armForward + swing.armBack);
    const double elbow = side == Side::Left ? -wave(phase - 0.08) : wave(phase - 0.08);
    placeArm(side, swing.armLower, mean + amplitude * forward, swing.elbow + swing.elbowSwing * elbow, pose);
  }
}

FigurePose stepAlong(const Gait& gait, const FootCurves& curves, const TrunkSwing& swing, const PerJoint<Vec3>& places,
                     double phase) {
  FigurePose pose;
  swingTrunk(gait, swing, phase, pose);
  placeFoot(places, Side::Left, footAt(gait, curves, places[indexOf(Joint::LeftToes)], phase), pose);
  placeFoot(places, Side::Right, footAt(gait, curves, places[indexOf(Joint::RightToes)], phase + 0.5), pose);
  return pose;
}

}  // namespace

FigurePose walk(const PerJoint<Vec3>& places, double phase) {
  return stepAlong(walkGait, walkCurves(), walkSwing, places, phase);
}

FigurePose run(const PerJoint<Vec3>& places, double phase) {
  return stepAlong(runGait, runCurves(), runSwing, places, phase);
}

}  // namespace drape::figure
