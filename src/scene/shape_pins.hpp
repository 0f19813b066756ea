#pragma once

#include "sim/cloth_model.hpp"

#include <vector>

namespace drape {

/// The vertices by which a cloth would be hung up, y up, ascending. Of a garment the opening that is nearest to the top
/// and faces up or down (neck, waist); where that reaches far down, as the neck of a tank top, only what is near the
/// shoulders. Of a flat sheet two corners: the upper ones, or those at the back when it lies level. Of other sheets
/// what is topmost along their border, and of what has no border its topmost vertices. Each piece of the mesh is held,
/// but for those that are small beside the largest one.
[[nodiscard]] std::vector<int> pinsByShape(const ClothMesh& mesh);

}  // namespace drape
