#pragma once

#include "figure/skeleton.hpp"
#include "sim/contact/bodies/pose.hpp"

namespace drape::figure {

/// A pose of the figure. Without a rotation and a shift it is the rest pose.
struct FigurePose {
  Vec3 shift = Vec3::Zero();  ///< of the hips from their rest position [m]
  /// By which the figure turns to the left, about the vertical through its hips [degrees]. It can exceed a turn, so
  /// that the way from one heading to another is known.
  double heading = 0.0;
  /// Of each joint relative to its parent, about its own position. In the rest pose the axes of all joints are those of
  /// the world.
  PerJoint<Eigen::Quaterniond> rotations;

  FigurePose() { rotations.fill(Eigen::Quaterniond::Identity()); }
  [[nodiscard]] Eigen::Quaterniond& rotation(Joint joint) { return rotations[indexOf(joint)]; }
};

/// How the hips are turned in the world: by their own rotation, then by the heading.
[[nodiscard]] Eigen::Quaterniond hipsRotation(const FigurePose& pose);

/// The pose between two: 0 is the first, 1 the second. Rotations take the shorter way, and the heading that of numbers.
[[nodiscard]] FigurePose blended(const FigurePose& first, const FigurePose& second, double fraction);

/// Where a pose puts each joint, and how it turns the bone there.
/// @param places of the joints in the rest pose [m]
[[nodiscard]] PerJoint<sim::contact::Pose> jointPoses(const PerJoint<Vec3>& places, const FigurePose& pose);

/// A rotation about an axis through the origin [degrees].
[[nodiscard]] Eigen::Quaterniond turned(double degrees, const Vec3& axis);

}  // namespace drape::figure
