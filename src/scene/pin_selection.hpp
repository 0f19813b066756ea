#pragma once

#include "scene/grid_mesh.hpp"
#include "scene/scene.hpp"

namespace drape {

/// The vertices that a selection picks from a rest shape, sorted, each once. `grid` is the layout when the cloth is a
/// grid, else nullptr. Throws InputError for an index out of range or for corners and edges of what is no grid.
[[nodiscard]] std::vector<int> selectPins(const PinSelection& pins, const std::vector<Vec3>& restPositions,
                                          const GridLayout* grid);

}  // namespace drape
