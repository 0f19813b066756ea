#pragma once

#include "figure/figure_pose.hpp"

#include <span>
#include <string>
#include <string_view>

namespace drape::figure {

/// A motion of the figure. It loops.
struct Motion {
  std::string_view name;
  std::string_view title;
  double period = 1.0;  ///< [s]
  double pace = 0.0;    ///< speed of the ground below the feet, backwards [m/s]
  int turns = 0;        ///< whole turns to the left in a period
  /// The pose at a share of the period, 0 to 1. Its derivative is continuous. `places` are those of the joints in the
  /// rest pose [m].
  FigurePose (*pose)(const PerJoint<Vec3>& places, double phase) = nullptr;
};

/// All motions. A new one is a row here.
[[nodiscard]] std::span<const Motion> motions();

/// The motion with this name; null if there is none.
[[nodiscard]] const Motion* findMotion(std::string_view name);

/// The names of all motions, separated by commas.
[[nodiscard]] std::string motionNames();

// The rows' functions.
[[nodiscard]] FigurePose restPose(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose tPose(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose aPose(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose breathe(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose walk(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose run(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose skate(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose turnRound(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose squat(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose raiseArms(const PerJoint<Vec3>& places, double phase);
[[nodiscard]] FigurePose dance(const PerJoint<Vec3>& places, double phase);

/// Lowers an arm from the rest pose, swings it forward and bends its elbow [degrees]. Both sides are mirror images.
/// @param lower beyond the rest pose, in which the upper arm points 28 degrees below the horizontal
void placeArm(Side side, double lower, double forward, double elbow, FigurePose& pose);

}  // namespace drape::figure
