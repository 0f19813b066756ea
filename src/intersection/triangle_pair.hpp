#pragma once

#include "intersection/facet.hpp"

namespace drape::intersection {

/// Whether two triangles without common vertices have a point in common. Triangles are closed: touching counts.
[[nodiscard]] bool meet(const Facet& first, const Facet& second);

/// Whether two triangles with a common corner 0 have another point in common.
[[nodiscard]] bool meetBeyondCorner(const Facet& first, const Facet& second);

/// Whether two triangles with a common edge, between their corners 0 and 1, have a point in common outside it: one is
/// folded flat onto the other.
[[nodiscard]] bool meetBeyondEdge(const Facet& first, const Facet& second);

}  // namespace drape::intersection
