#pragma once

#include "sim/vector.hpp"

#include <optional>
#include <vector>

namespace drape {

/// What collapseShortEdges did.
struct ShortEdges {
  std::vector<int> replacement;  ///< for each vertex the one that stands in for it, often itself
  int collapsed = 0;             ///< edges that became one vertex
  int kept = 0;                  ///< edges that had to stay, because the mesh would fold or become non-manifold
  std::optional<Vec3> where;     ///< one end of the first of all these edges, in the unit of the positions
};

/// Finds the edges shorter than `limit` and merges the two ends of each, shortest edge first. The end with the lower
/// number stays where it is. An edge stays when its collapse would change how the mesh hangs together (link condition,
/// Dey et al. 1999, "Topology preserving edge contraction") or turn a face over. Faces with two equal corners after
/// the replacement have vanished; the caller drops them.
/// Every index must be in range, and no face may have two equal corners.
[[nodiscard]] ShortEdges collapseShortEdges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                            double limit);

}  // namespace drape
