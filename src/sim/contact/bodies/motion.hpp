#pragma once

#include "sim/contact/bodies/pose.hpp"
#include "sim/model/vector.hpp"

#include <optional>
#include <vector>

namespace drape::sim::contact {

/// The pose of a body at a given time.
struct Keyframe {
  double time = 0.0;             ///< [s]
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 rotation = Vec3::Zero();  ///< axis times angle [rad]; more than a turn is allowed

  bool operator==(const Keyframe&) const = default;
};

/// The prescribed motion of a body. Between keyframes each component follows a cubic curve with continuous velocity
/// that stays between the two values (monotone interpolation, Fritsch and Carlson 1980): it never overshoots. Before
/// the first keyframe and after the last one the body is at rest, and the velocity is zero at both. With `loop` the
/// motion continues from the last keyframe to the first without a stop; the two should be equal (rotations up to whole
/// turns).
struct BodyMotion {
  std::vector<Keyframe> keyframes;  ///< at least one, times ascending
  bool loop = false;
  Vec3 spin = Vec3::Zero();  ///< additional rotation about the origin of its frame: axis times angular velocity [rad/s]
  std::optional<Pose> placement;  ///< applied after all of this; empty: none

  [[nodiscard]] bool moves() const { return keyframes.size() > 1 || !spin.isZero(0.0); }

  bool operator==(const BodyMotion&) const = default;
};

/// The pose with this position [m] and rotation, axis times angle [rad].
[[nodiscard]] Pose poseOf(const Vec3& position, const Vec3& rotation);

/// The interpolated values of a motion at that time [s], without its spin and its placement. Zero without keyframes.
[[nodiscard]] Keyframe keyframeAt(const BodyMotion& motion, double time);

/// The pose of a body at that time [s], with spin and placement.
[[nodiscard]] Pose poseAt(const BodyMotion& motion, double time);

}  // namespace drape::sim::contact
