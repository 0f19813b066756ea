#pragma once

#include "sim/contact/bodies/pose.hpp"
#include "sim/vector.hpp"

#include <vector>

namespace drape {

/// Where a body is at some time.
struct Keyframe {
  double time = 0.0;             ///< [s]
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 rotation = Vec3::Zero();  ///< axis times angle [rad]; more than a turn is allowed
};

/// How a body moves by itself. Between keyframes each component follows a cubic curve whose velocity does not jump and
/// which stays between the two values (monotone interpolation, Fritsch and Carlson 1980): it never overshoots. Before
/// the first keyframe and after the last one the body rests, and it comes to rest there smoothly; with `loop` the first
/// follows the last without a stop, and they should be alike (rotations up to whole turns).
struct BodyMotion {
  std::vector<Keyframe> keyframes;  ///< at least one, times ascending
  bool loop = false;
  Vec3 spin = Vec3::Zero();  ///< turns about its own centre as well: axis times angular velocity [rad/s]

  [[nodiscard]] bool moves() const { return keyframes.size() > 1 || !spin.isZero(0.0); }
};

/// Where a thing is that stands still there [m], turned by axis times angle [rad].
[[nodiscard]] Pose poseOf(const Vec3& position, const Vec3& rotation);

[[nodiscard]] Pose poseAt(const BodyMotion& motion, double time);

}  // namespace drape
