#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"

#include <span>

namespace drape {

/// How many dimensions points fill: 0 a point, 1 a line, 2 a plane, 3 space. What sticks out by less than `thickness`
/// [m] does not count.
[[nodiscard]] int dimensionsOf(std::span<const Vec3> points, double thickness);

/// A state that is flatter than the rest shape (all vertices on a plane, a line or at one point, though the rest shape
/// fills more) has no force that leads out of it: springs without length have no direction, and all others lie in the
/// line or plane. This adds a millionth of the rest shape, about its middle, so that the cloth unfolds, and always in
/// the same way. Pinned vertices stay. True when there was something to do.
bool makeUnfoldable(const ClothModel& model, ClothState& state);

}  // namespace drape
