#include "figure/leg.hpp"
#include "figure/motions.hpp"
#include "figure/periodic_curve.hpp"

#include <cmath>
#include <numbers>

namespace drape::figure {
namespace {

constexpr double hangingArm = 42.0;  // from the rest pose to an arm that hangs beside the body [degrees]

double sine(double phase) {
  return std::sin(2.0 * std::numbers::pi * phase);
}

/// From 0 at phase 0 to 1 at phase 0.5 and back.
double swell(double phase) {
  return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * phase);
}

/// The foot of the rest pose, moved.
FootPlace standing(const PerJoint<Vec3>& places, Side side, const Vec3& shift = Vec3::Zero()) {
  FootPlace foot;
  foot.ball = places[indexOf(onSide(Joint::LeftToes, side))] + shift;
  return foot;
}

void standOn(const PerJoint<Vec3>& places, FigurePose& pose) {
  placeFoot(places, Side::Left, standing(places, Side::Left), pose);
  placeFoot(places, Side::Right, standing(places, Side::Right), pose);
}

void placeArms(double lower, double forward, double elbow, FigurePose& pose) {
  placeArm(Side::Left, lower, forward, elbow, pose);
  placeArm(Side::Right, lower, forward, elbow, pose);
}

/// How far a foot has turned when it takes `count` steps in a turn, as a share of the turn, and how high it is above
/// the ground, 0 to 1.
struct TurningFoot {
  double turn = 0.0;
  double lift = 0.0;
};

TurningFoot turningFoot(double phase, int count, double offset) {
  constexpr double swing = 0.42;  // the share of a step in which the foot moves
  const double steps = phase * count + offset;
  const double t = (fractionOf(steps) - 0.5) / swing + 0.5;
  const double part = smoothStep(t);
  return {(std::floor(steps) + part - offset) / count, 16.0 * part * part * (1.0 - part) * (1.0 - part)};
}

}  // namespace

FigurePose restPose(const PerJoint<Vec3>& /*places*/, double /*phase*/) {
  return {};
}

FigurePose tPose(const PerJoint<Vec3>& /*places*/, double /*phase*/) {
  FigurePose pose;
  placeArms(-28.4, 0.0, 0.0, pose);
  pose.rotation(Joint::LeftForearm) = turned(7.9, Vec3::UnitZ());
  pose.rotation(Joint::RightForearm) = turned(-7.9, Vec3::UnitZ());
  return pose;
}

FigurePose aPose(const PerJoint<Vec3>& /*places*/, double /*phase*/) {
  FigurePose pose;
  placeArms(18.0, 0.0, 4.0, pose);
  return pose;
}

FigurePose breathe(const PerJoint<Vec3>& places, double phase) {
  FigurePose pose;
  const double breath = swell(phase);
  pose.shift = Vec3(0.006 * sine(phase), -0.012 + 0.002 * breath, 0.0);
  pose.rotation(Joint::Chest) = turned(-2.5 * breath, Vec3::UnitX());
  pose.rotation(Joint::Neck) = turned(1.8 * breath, Vec3::UnitX());
  pose.rotation(Joint::LeftShoulder) = turned(4.0 * breath, Vec3::UnitZ());
  pose.rotation(Joint::RightShoulder) = turned(-4.0 * breath, Vec3::UnitZ());
  placeArms(hangingArm - 3.0 * breath, 4.0, 14.0, pose);
  standOn(places, pose);
  return pose;
}

FigurePose turnRound(const PerJoint<Vec3>& places, double phase) {
  constexpr int steps = 6;  // of each foot in a turn
  FigurePose pose;
  pose.heading = 360.0 * phase;
  pose.shift = Vec3(0.0, -0.022 + 0.004 * sine(2.0 * steps * phase), 0.0);
  pose.rotation(Joint::Chest) = turned(6.0, Vec3::UnitY());
  pose.rotation(Joint::Head) = turned(10.0, Vec3::UnitY());
  placeArm(Side::Left, hangingArm - 6.0, -8.0 + 4.0 * sine(steps * phase), 16.0, pose);
  placeArm(Side::Right, hangingArm - 6.0, 10.0 - 4.0 * sine(steps * phase), 18.0, pose);
  for (const Side side : {Side::Left, Side::Right}) {
    const TurningFoot turning = turningFoot(phase, steps, side == Side::Left ? 0.5 : 0.0);
    FootPlace foot = standing(places, side);
    foot.yaw = 360.0 * turning.turn;
    foot.ball = turned(foot.yaw, Vec3::UnitY()) * foot.ball + Vec3(0.0, 0.035 * turning.lift, 0.0);
    foot.pitch = -14.0 * turning.lift;
    placeFoot(places, side, foot, pose);
  }
  return pose;
}

FigurePose squat(const PerJoint<Vec3>& places, double phase) {
  FigurePose pose;
  const double depth = swell(phase);
  pose.shift = Vec3(0.0, -0.012 - 0.33 * depth, -0.13 * depth);
  pose.rotation(Joint::Hips) = turned(22.0 * depth, Vec3::UnitX());
  pose.rotation(Joint::Spine) = turned(8.0 * depth, Vec3::UnitX());
  pose.rotation(Joint::Chest) = turned(2.0 * depth, Vec3::UnitX());
  pose.rotation(Joint::Neck) = turned(-14.0 * depth, Vec3::UnitX());
  pose.rotation(Joint::Head) = turned(-10.0 * depth, Vec3::UnitX());
  placeArms(hangingArm, 4.0 + 92.0 * depth, 12.0 + 8.0 * depth, pose);
  for (const Side side : {Side::Left, Side::Right}) {
    FootPlace foot = standing(places, side);
    foot.yaw = side == Side::Left ? 12.0 : -12.0;
    placeFoot(places, side, foot, pose);
  }
  return pose;
}

FigurePose raiseArms(const PerJoint<Vec3>& places, double phase) {
  FigurePose pose;
  const double height = swell(phase);
  pose.shift = Vec3(0.0, -0.012, 0.0);
  placeArms(hangingArm - 125.0 * height, 4.0, 14.0 - 8.0 * height, pose);
  pose.rotation(Joint::LeftShoulder) = turned(18.0 * height, Vec3::UnitZ());
  pose.rotation(Joint::RightShoulder) = turned(-18.0 * height, Vec3::UnitZ());
  standOn(places, pose);
  return pose;
}

FigurePose dance(const PerJoint<Vec3>& places, double phase) {
  // Eight beats of a second. The weight goes from foot to foot in two beats; the trunk turns in four.
  FigurePose pose;
  const double weight = sine(4.0 * phase);  // 1: on the left foot
  const double twist = sine(2.0 * phase);
  const double slow = sine(phase);
  const double show = swell(phase);
  pose.shift = Vec3(0.075 * weight, -0.050 - 0.018 * std::cos(16.0 * std::numbers::pi * phase), 0.02 * twist);
  pose.rotation(Joint::Hips) =
      turned(26.0 * twist, Vec3::UnitY()) * turned(6.0 * weight, Vec3::UnitZ()) * turned(3.0 * slow, Vec3::UnitX());
  pose.rotation(Joint::Spine) = turned(-10.0 * twist, Vec3::UnitY()) * turned(-6.0 * weight, Vec3::UnitZ());
  pose.rotation(Joint::Chest) = turned(-12.0 * twist, Vec3::UnitY()) * turned(-5.0 * weight, Vec3::UnitZ());
  pose.rotation(Joint::Neck) = turned(4.0 * weight, Vec3::UnitZ()) * turned(4.0 * twist, Vec3::UnitY());
  pose.rotation(Joint::Head) = turned(4.0 * weight, Vec3::UnitZ()) * turned(6.0 * slow, Vec3::UnitY());
  placeArm(Side::Left, 10.0 - 45.0 * show - 16.0 * weight, 14.0 + 16.0 * twist, 30.0 + 14.0 * weight, pose);
  placeArm(Side::Right, 10.0 - 45.0 * show + 16.0 * weight, 14.0 - 16.0 * twist, 30.0 - 14.0 * weight, pose);
  for (const Side side : {Side::Left, Side::Right}) {
    const double own = side == Side::Left ? weight : -weight;
    const double free = smoothStep((-own - 0.15) / 0.7);  // the foot without weight
    const double out = side == Side::Left ? 1.0 : -1.0;
    FootPlace foot = standing(places, side, Vec3(0.055 * out, 0.0, 0.0));
    foot.yaw = 12.0 * out + 8.0 * twist * free;
    foot.pitch = -30.0 * free;
    foot.toes = 26.0 * free;
    foot.ball += Vec3(0.0, 0.012 * free, 0.045 * free);
    placeFoot(places, side, foot, pose);
  }
  return pose;
}

}  // namespace drape::figure
