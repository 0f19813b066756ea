#pragma once

#include "figure/figure_pose.hpp"

namespace drape::figure {

/// A foot on its way.
struct FootPlace {
  Vec3 ball = Vec3::Zero();  ///< where the joint of the toes is [m]
  double yaw = 0.0;          ///< to the left [degrees]
  double pitch = 0.0;        ///< toes up [degrees]
  double toes = 0.0;         ///< toes up relative to the foot [degrees]
};

/// Bends a leg so that its foot is at a place. The hips and the heading of the pose must be set. A foot out of reach
/// stays on the straight line to its place. @param places of the joints in the rest pose [m]
void placeFoot(const PerJoint<Vec3>& places, Side side, const FootPlace& foot, FigurePose& pose);

}  // namespace drape::figure
