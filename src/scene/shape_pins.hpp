#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::scene {

/// The vertices by which a cloth would be hung up, y up, ascending. For a garment: the opening nearest to the top that
/// faces up or down (neck, waist). When it extends far down, as the neck of a tank top, only its part near the
/// shoulders. For a flat sheet: two corners, the upper ones or, when it lies level, those at the back. For other
/// sheets: the topmost part of the border. Without a border: the topmost vertices. Every piece of the mesh is pinned,
/// except pieces that are small compared with the largest one.
[[nodiscard]] std::vector<int> pinsByShape(const sim::ClothMesh& mesh);

}  // namespace drape::scene
