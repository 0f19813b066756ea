#include "scene/open_neckline.hpp"

#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace drape::scene {
namespace {

/// The larger horizontal extent.
double widthOf(const Eigen::AlignedBox3d& box, int up) {
  return std::max(box.sizes()[(up + 1) % 3], box.sizes()[(up + 2) % 3]);
}

/// The longest run of neighbours of a closed loop that are above a height; empty if all are.
std::vector<int> runAbove(std::span<const int> loop, const std::vector<Vec3>& positions, int up, double height) {
  const std::size_t count = loop.size();
  const auto isAbove = [&](std::size_t i) { return positions[loop[i % count]][up] >= height; };
  std::size_t begin = 0;
  while (begin < count && isAbove(begin)) {
    ++begin;  // a run starts after a vertex that is lower
  }
  std::vector<int> longest;
  std::vector<int> run;
  for (std::size_t i = begin; begin < count && i <= begin + count; ++i) {
    if (isAbove(i)) {
      run.push_back(loop[i % count]);
    } else {
      if (run.size() > longest.size()) {
        longest = run;
      }
      run.clear();
    }
  }
  return longest;
}

/// A run as seen from above, closed by a straight line.
struct SeenFromAbove {
  double length = 0.0;     ///< of the run itself
  double roundness = 0.0;  ///< its area over that of the circle with its larger extent as diameter [-]
};

SeenFromAbove seenFromAbove(const std::vector<int>& run, const std::vector<Vec3>& positions, int up) {
  SeenFromAbove seen;
  Eigen::AlignedBox3d box;
  double area = 0.0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const Vec3 a = positions[run[i]] - positions[run.front()];
    const Vec3 b = positions[run[(i + 1) % run.size()]] - positions[run.front()];
    area += 0.5 * a.cross(b)[up];
    seen.length += i + 1 < run.size() ? (b - a).norm() : 0.0;
    box.extend(a);
  }
  const double width = run.empty() ? 0.0 : widthOf(box, up);
  seen.roundness = width > 0.0 ? std::abs(area) / (0.25 * std::numbers::pi * width * width) : 0.0;
  return seen;
}

OpenNeckline measured(std::vector<int> run, const std::vector<Vec3>& positions, int up) {
  OpenNeckline neckline;
  Eigen::AlignedBox3d box;
  for (const int vertex : run) {
    neckline.centre += positions[vertex] / static_cast<double>(run.size());
    box.extend(positions[vertex]);
  }
  neckline.width = widthOf(box, up);
  neckline.gap = 0.5 * (positions[run.front()] + positions[run.back()]);
  neckline.vertices = std::move(run);
  return neckline;
}

}  // namespace

std::optional<OpenNeckline> findOpenNeckline(const sim::ClothMesh& garment, const ClothPieces& pieces, int up) {
  constexpr double lowest = 0.3;         // of the height, below the top
  constexpr int heights = 15;            // that are tried
  constexpr double minRoundness = 0.45;  // a half circle has 0.5
  constexpr double maxShare = 0.4;       // of the length of the outline
  constexpr double smallestWidth = 0.1;  // of the largest side of the garment
  const Eigen::AlignedBox3d box = sim::boundsOf(garment.positions);
  std::vector<int> best;
  double bestRoundness = minRoundness;
  for (const BoundaryLoop& loop : pieces.loops) {
    for (int k = 1; pieces.isOutline(loop) && k <= heights; ++k) {
      const double height = box.max()[up] - lowest * k / heights * box.sizes()[up];
      std::vector<int> run = runAbove(loop.vertices, garment.positions, up, height);
      const SeenFromAbove seen = seenFromAbove(run, garment.positions, up);
      if (seen.roundness > bestRoundness && seen.length < maxShare * loop.length) {
        bestRoundness = seen.roundness;
        best = std::move(run);
      }
    }
  }
  if (best.empty()) {
    return std::nullopt;
  }
  OpenNeckline neckline = measured(std::move(best), garment.positions, up);
  const bool isLarge = neckline.width > smallestWidth * box.sizes().maxCoeff();
  return isLarge ? std::optional(std::move(neckline)) : std::nullopt;
}

}  // namespace drape::scene
