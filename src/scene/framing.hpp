#pragma once

#include "scene/scene.hpp"

namespace drape::scene {

/// The axes of a camera in world space: it looks along -back.
struct CameraBasis {
  Vec3 right;
  Vec3 up;
  Vec3 back;
};
[[nodiscard]] CameraBasis basisOf(const CameraPose& pose);

/// From the focal point to the camera [m]; never zero.
[[nodiscard]] Vec3 viewOffset(const CameraPose& pose);

/// Tangent of half the vertical angle of view.
[[nodiscard]] double tanHalfAngle(const CameraPose& pose);

/// Minimum and maximum distance of a camera from its focal point [m].
inline constexpr double minViewDistance = 0.01;
inline constexpr double maxViewDistance = 400.0;

/// Whether the camera is at least minViewDistance from its focal point, apart from rounding.
[[nodiscard]] bool isFarEnough(const CameraPose& pose);

/// The pose with the direction of `pose` in which the box fills the view with a small margin.
/// @param aspect width over height of the picture
[[nodiscard]] CameraPose framed(const CameraPose& pose, const Vec3& min, const Vec3& max, double aspect);

}  // namespace drape::scene
