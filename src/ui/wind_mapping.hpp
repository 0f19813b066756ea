#pragma once

#include "sim/vector.hpp"

namespace drape {

/// The speed at the rim of the wind dial [m/s].
inline constexpr double dialSpeed = 20.0;

/// Where the arrow of the wind dial points, in radii from its centre: x to the right, y down the screen, which is
/// towards the viewer (+z). The square root gives gentle winds most of the room. Never beyond the rim.
[[nodiscard]] Vec2 dialOffset(const Vec3& wind);

/// The level wind for a place on the dial, to a hundredth of a metre per second; y is 0.
[[nodiscard]] Vec3 windFromDial(const Vec2& offset);

}  // namespace drape
