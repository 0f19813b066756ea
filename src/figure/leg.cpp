#include "figure/leg.hpp"

#include <algorithm>
#include <cmath>

namespace drape::figure {
namespace {

/// The rotation that takes one direction and the axis of its hinge to others.
Eigen::Quaterniond between(const Vec3& from, const Vec3& fromAxis, const Vec3& to, const Vec3& toAxis) {
  Mat3 first;
  Mat3 second;
  first << from, fromAxis, from.cross(fromAxis);
  second << to, toAxis, to.cross(toAxis);
  return Eigen::Quaterniond(Mat3(second * first.transpose())).normalized();
}

/// The axis of the knee's hinge for a bone in the rest pose.
Vec3 restAxis(const Vec3& bone) {
  return bone.cross(Vec3::UnitZ()).normalized();
}

}  // namespace

void placeFoot(const PerJoint<Vec3>& places, Side side, const FootPlace& foot, FigurePose& pose) {
  const std::size_t hip = indexOf(onSide(Joint::LeftThigh, side));
  const std::size_t knee = hip + 1;
  const std::size_t ankle = hip + 2;
  const std::size_t toes = hip + 3;
  const Eigen::Quaterniond footTurn = turned(foot.yaw, Vec3::UnitY()) * turned(-foot.pitch, Vec3::UnitX());
  const Vec3 target = foot.ball + footTurn * (places[ankle] - places[toes]);

  const Eigen::Quaterniond hips = hipsRotation(pose);
  const Vec3 from = places[0] + pose.shift + hips * (places[hip] - places[0]);
  const Vec3 restThigh = places[knee] - places[hip];
  const Vec3 restShin = places[ankle] - places[knee];
  const double thigh = restThigh.norm();
  const double shin = restShin.norm();
  const Vec3 along = (target - from).normalized();
  const double reach = std::clamp((target - from).norm(), std::abs(thigh - shin) + 1e-6, thigh + shin - 1e-6);

  // The knee points between the directions of the hips and the foot.
  const Vec3 forward = hips * Vec3::UnitZ() + turned(foot.yaw, Vec3::UnitY()) * Vec3::UnitZ();
  const Vec3 axis = along.cross(forward).normalized();
  const Vec3 front = axis.cross(along);
  const double cosine = (thigh * thigh + reach * reach - shin * shin) / (2.0 * thigh * reach);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const Vec3 thighNow = cosine * along + sine * front;
  const Vec3 shinNow = (reach * along - thigh * thighNow) / shin;

  const Eigen::Quaterniond thighTurn = between(restThigh / thigh, restAxis(restThigh), thighNow, axis);
  const Eigen::Quaterniond shinTurn = between(restShin / shin, restAxis(restShin), shinNow.normalized(), axis);
  pose.rotations[hip] = hips.conjugate() * thighTurn;
  pose.rotations[knee] = thighTurn.conjugate() * shinTurn;
  pose.rotations[ankle] = shinTurn.conjugate() * footTurn;
  pose.rotations[toes] = turned(-foot.toes, Vec3::UnitX());
}

}  // namespace drape::figure
