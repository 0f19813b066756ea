#pragma once

#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// Two vertices that a seam joins.
struct SeamPair {
  int a = 0;
  int b = 0;

  friend bool operator==(const SeamPair&, const SeamPair&) = default;
};

/// Pairs of vertices that are drawn together and, when all of them are close, welded. No number of it changes during a
/// simulation: a seam is welded in those states in which its pairs coincide (isWelded).
struct Seam {
  std::vector<SeamPair> pairs;
  double duration = 1.0;  ///< from its start until it is closed, if nothing is in its way [s]
  double start = 0.0;     ///< time from which it is drawn together [s]
};

/// Whether both vertices of each pair are at the same place, to the last bit.
[[nodiscard]] bool isWelded(const Seam& seam, std::span<const Vec3> positions);

/// For each vertex the one that it becomes when these seams are welded: the first pinned vertex of those that are
/// joined, otherwise the lowest.
[[nodiscard]] std::vector<int> leadersOf(std::span<const Seam> seams, const std::vector<bool>& pinned);

}  // namespace drape::sim
