#pragma once

#include "sim/model/cloth_model.hpp"

#include <memory>
#include <vector>

namespace drape::sim::adaptive {

/// A coarse level of a cloth: the vertices of the next finer level, gathered in aggregates.
///
/// The aggregates form a cloth model. An aggregate's rest position is the mass-weighted mean of its members, its mass
/// is their sum, and springs with the rest distance as rest length connect neighbouring aggregates. Pinned and free
/// vertices are never in one aggregate. So an aggregate of pinned vertices is pinned and transfers tension to the pins.
struct CoarseLevel {
  std::vector<int> aggregateOf;             ///< of each vertex of the finer level
  std::shared_ptr<const ClothModel> cloth;  ///< the aggregates as vertices; it has no triangles and no areas
};

/// Levels from fine to coarse. They depend on the rest shape and the pins only. The last level has few aggregates.
///
/// The roots of the aggregates are a maximal independent set of the spring graph, a quarter to a third of the vertices.
/// Every other vertex joins the nearest adjacent root. The set starts along the boundary, so that the aggregates form
/// straight rows along free edges: a zigzag row would straighten under tension before it carries load
/// (docs/theory/auto.md).
[[nodiscard]] std::vector<CoarseLevel> buildCoarseLevels(const ClothModel& model);

}  // namespace drape::sim::adaptive
