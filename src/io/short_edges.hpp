#pragma once

#include "sim/model/vector.hpp"

#include <optional>
#include <vector>

namespace drape::io {

/// The result of collapseShortEdges.
struct ShortEdges {
  std::vector<int> replacement;  ///< the replacement of each vertex, often itself
  int collapsed = 0;             ///< merged edges
  int kept = 0;                  ///< edges that stay, since the mesh would fold or become non-manifold
  std::optional<Vec3> where;     ///< one end of the first of these edges, in the unit of the positions
};

/// Merges the two ends of every edge shorter than `limit`, shortest edge first. The end with the lower index keeps its
/// position. An edge stays when its collapse would change the topology (link condition, Dey et al. 1999, "Topology
/// preserving edge contraction") or flip a face. Faces with two equal corners after the replacement have vanished; the
/// caller drops them. All indices must be in range, and no face may have two equal corners at the start.
[[nodiscard]] ShortEdges collapseShortEdges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                            double limit);

}  // namespace drape::io
