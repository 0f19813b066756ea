#pragma once

#include "scene/cloth_builder.hpp"
#include "scene/scene.hpp"
#include "sim/model/seams.hpp"

#include <span>
#include <vector>

namespace drape::scene {

/// The seams of a scene, between vertices of its model. Throws InputError for a cloth or a vertex that does not exist,
/// a point that is not on an open border, a pair that cannot be sewn, and cloths of different fabrics.
[[nodiscard]] std::vector<sim::Seam> seamsOf(std::span<const SeamDescription> seams, const JoinedCloths& joined,
                                             const sim::ClothModel& model);

}  // namespace drape::scene
