#pragma once

#include "scene/grid_mesh.hpp"
#include "scene/scene.hpp"

namespace drape::scene {

/// The selected vertices of a rest shape, sorted, without duplicates. `grid` is the layout of a grid, otherwise
/// nullptr. Throws InputError, with the place in the file, for an index out of range, or for corners and edges of a
/// cloth that is not a grid.
[[nodiscard]] std::vector<int> selectPins(const PinSelection& pins, const std::vector<Vec3>& restPositions,
                                          const GridLayout* grid);

}  // namespace drape::scene
