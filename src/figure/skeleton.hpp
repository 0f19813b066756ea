#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace drape::figure {

/// The joints of the figure. A parent comes before its children. Left is +x: the figure faces +z.
enum class Joint {
  Hips,
  Spine,
  Chest,
  Neck,
  Head,
  LeftShoulder,
  LeftUpperArm,
  LeftForearm,
  LeftHand,
  RightShoulder,
  RightUpperArm,
  RightForearm,
  RightHand,
  LeftThigh,
  LeftShin,
  LeftFoot,
  LeftToes,
  RightThigh,
  RightShin,
  RightFoot,
  RightToes
};
inline constexpr std::size_t jointCount = 21;

/// One value for each joint, by its number in the enumeration.
template <typename T>
using PerJoint = std::array<T, jointCount>;

[[nodiscard]] constexpr std::size_t indexOf(Joint joint) {
  return static_cast<std::size_t>(joint);
}

enum class Side { Left, Right };

/// The joint of the other side for `Right`. @param left a joint of an arm or a leg on the left
[[nodiscard]] Joint onSide(Joint left, Side side);

/// A joint in the rest pose, in which the garments are fitted, and the bone that it moves.
struct JointInfo {
  std::string_view name;
  Joint parent = Joint::Hips;  ///< that of the hips is the hips
  Vec3 rest;                   ///< the joint, where the bone begins [m]
  Vec3 end;                    ///< where the bone ends [m]
  double radius = 0.0;         ///< of the body around the bone [m]
};

/// The joints of the figure as it is built: y up, above a ground at y = 0.
[[nodiscard]] const PerJoint<JointInfo>& skeleton();

/// The position of a joint in the rest pose [m].
[[nodiscard]] inline const Vec3& restOf(Joint joint) {
  return skeleton()[indexOf(joint)].rest;
}

/// The positions of all joints in the rest pose [m].
[[nodiscard]] PerJoint<Vec3> restPlaces();

}  // namespace drape::figure
