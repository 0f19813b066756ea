#pragma once

#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim::simd {

/// The point relative to which a step calculates positions [m]. In float it is near the middle of the cloth, because
/// coordinates far from zero would be rounded more. In double it is zero.
///
/// It is a multiple of a power of two that is at most a quarter of the size of the cloth. So cloth that moves little
/// keeps its origin, and positions are not rounded again from step to step.
template <typename T>
[[nodiscard]] Vec3 stepOrigin(std::span<const Vec3> positions);

}  // namespace drape::sim::simd
