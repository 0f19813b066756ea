#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <span>

namespace drape::sim {

/// The dimension of a set of points: 0 a point, 1 a line, 2 a plane, 3 space. Deviations below `thickness` [m] do not
/// count.
[[nodiscard]] int dimensionsOf(std::span<const Vec3> points, double thickness);

/// Lets a state unfold that is flatter than the rest shape: all vertices on a plane, on a line or at a point, while the
/// rest shape has a higher dimension. No force leads out of such a state: springs of zero length have no direction, and
/// all others lie in the line or plane. So this adds a millionth of the rest shape, relative to its centre. Pinned
/// vertices stay. True if the state was changed.
bool makeUnfoldable(const ClothModel& model, ClothState& state);

}  // namespace drape::sim
