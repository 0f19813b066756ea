#pragma once

#include "sim/model/vector.hpp"

namespace drape::ui {

/// The speed at the rim of the wind dial [m/s].
inline constexpr double dialSpeed = 20.0;

/// The tip of the dial's arrow, in radii from the centre: x to the right, y down the screen (+z, towards the viewer).
/// The square root leaves most of the area to light winds. Never beyond the rim.
[[nodiscard]] Vec2 dialOffset(const Vec3& wind);

/// The horizontal wind for a point on the dial, rounded to 0.01 m/s; y is 0.
[[nodiscard]] Vec3 windFromDial(const Vec2& offset);

}  // namespace drape::ui
