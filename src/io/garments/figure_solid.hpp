#pragma once

#include "sim/model/vector.hpp"

namespace drape::io {

/// The approximate signed distance of a point from head, trunk, arms and upper legs of the figure in its rest pose [m].
[[nodiscard]] double distanceToFigure(const Vec3& point);

}  // namespace drape::io
