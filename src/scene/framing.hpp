#pragma once

#include "scene/scene.hpp"

namespace drape {

/// The pose that looks in the same direction as `pose` and whose view is filled by the sphere around the box.
/// @param aspect width over height of the picture
[[nodiscard]] CameraPose framed(const CameraPose& pose, const Vec3& min, const Vec3& max, double aspect);

}  // namespace drape
