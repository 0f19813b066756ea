#pragma once

#include "sim/cloth_model.hpp"

#include <memory>
#include <vector>

namespace drape {

/// A coarse level of a cloth: its vertices, or the groups of the level below, gathered in groups that move as one.
///
/// The groups are a cloth in their own right: each stands where its members' mean is, weighted by mass, has their mass
/// together, and is tied to the groups next to it by springs that are as long as in the rest shape. Pinned and free
/// vertices never share a group, so that a group of pinned ones is held and passes tension on to what holds it.
struct CoarseLevel {
  std::vector<int> groupOf;                 ///< one a member: the group that it is in
  std::shared_ptr<const ClothModel> cloth;  ///< the groups; it has no triangles and no areas
};

/// Levels from fine to coarse, from the rest shape and the pins alone; the last one has no more than a few groups.
/// A quarter to a third of the members are seeds, a maximal independent set that is begun along the rim, and every
/// other goes with the nearest seed next to it. Along a free edge the groups so stand in a row: tension in a row that
/// goes to and fro would find the slack in it (docs/theory/auto.md).
[[nodiscard]] std::vector<CoarseLevel> buildCoarseLevels(const ClothModel& model);

}  // namespace drape
