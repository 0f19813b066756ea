#pragma once

#include "sim/model/cloth_model.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// The same cloth with vertices welded, as by a finished seam. Triangles and springs refer to the leaders, which also
/// have the masses and the areas. The other vertices keep their numbers but have no triangle, no spring and hardly any
/// mass. They count as pinned: no solver moves them, and the caller keeps them at their leaders.
///
/// The rest shape of each triangle is as before, so that no triangle is strained by the weld. Across a seam the fabric
/// is flat at rest. Cloths that a seam joins count as one.
/// @param leaders the vertex that each vertex becomes; its own number for one that stays
/// Throws ClothModelError if triangles of different materials then have a common vertex.
[[nodiscard]] std::shared_ptr<const ClothModel> withWelds(const ClothModel& model, std::span<const int> leaders);

/// The mean of the values of all vertices that are welded to the same leader, weighted by mass, for each leader; the
/// own value for every other vertex. @param leaders as in withWelds
[[nodiscard]] std::vector<Vec3> meansOfWelded(const ClothModel& model, std::span<const int> leaders,
                                              std::span<const Vec3> values);

/// Whether a vertex is welded to another one, which has its triangles.
[[nodiscard]] bool isFollower(const ClothModel& model, int vertex);

/// The pins of a cloth without those vertices that count as pinned because they are welded to another one.
[[nodiscard]] std::vector<bool> ownPinsOf(const ClothModel& model);

}  // namespace drape::sim::fabric
