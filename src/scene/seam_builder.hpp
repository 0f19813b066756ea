#pragma once

#include "scene/scene.hpp"
#include "sim/model/seams.hpp"

#include <span>
#include <string>
#include <vector>

namespace drape::scene {

/// Builds the seams of a scene, between vertices of its model. Throws InputError for a cloth or a vertex that does not
/// exist, a point that is not on an open border, a pair that cannot be sewn, vertices that other seams join already,
/// and cloths of different fabrics.
/// @param mesh the cloths without their placements  @param before other seams of the scene
/// @param notes gets a sentence about each seam whose sides have different numbers of vertices; null: nobody reads them
/// @return `before` with the new ones
[[nodiscard]] std::vector<sim::Seam> seamsOf(std::span<const SeamDescription> seams, const sim::ClothMesh& mesh,
                                             std::span<const ClothPart> cloths, const sim::ClothModel& model,
                                             std::vector<sim::Seam> before = {},
                                             std::vector<std::string>* notes = nullptr);

}  // namespace drape::scene
