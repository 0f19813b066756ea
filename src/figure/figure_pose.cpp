#include "figure/figure_pose.hpp"

#include <numbers>

namespace drape::figure {

Eigen::Quaterniond hipsRotation(const FigurePose& pose) {
  return turned(pose.heading, Vec3::UnitY()) * pose.rotations[indexOf(Joint::Hips)];
}

FigurePose blended(const FigurePose& first, const FigurePose& second, double fraction) {
  FigurePose pose;
  pose.shift = (1.0 - fraction) * first.shift + fraction * second.shift;
  pose.heading = (1.0 - fraction) * first.heading + fraction * second.heading;
  for (std::size_t j = 0; j < jointCount; ++j) {
    pose.rotations[j] = first.rotations[j].slerp(fraction, second.rotations[j]);
  }
  return pose;
}

PerJoint<sim::contact::Pose> jointPoses(const PerJoint<Vec3>& places, const FigurePose& pose) {
  PerJoint<sim::contact::Pose> poses;
  poses[0] = {hipsRotation(pose), places[0] + pose.shift};
  for (std::size_t j = 1; j < jointCount; ++j) {
    const std::size_t parent = indexOf(skeleton()[j].parent);
    poses[j].rotation = (poses[parent].rotation * pose.rotations[j]).normalized();
    poses[j].position = poses[parent].toWorld(places[j] - places[parent]);
  }
  return poses;
}

Eigen::Quaterniond turned(double degrees, const Vec3& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis));
}

}  // namespace drape::figure
