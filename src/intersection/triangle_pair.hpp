#pragma once

#include "intersection/facet.hpp"

namespace drape {

/// Whether two triangles that share no vertex have a point in common. Triangles are closed: touching counts.
[[nodiscard]] bool meet(const Facet& first, const Facet& second);

/// Whether two triangles that share their corner 0 have any other point in common.
[[nodiscard]] bool meetBeyondCorner(const Facet& first, const Facet& second);

/// Whether two triangles that share the edge between their corners 0 and 1 have any point in common that is not on it:
/// one is folded flat onto the other.
[[nodiscard]] bool meetBeyondEdge(const Facet& first, const Facet& second);

}  // namespace drape
