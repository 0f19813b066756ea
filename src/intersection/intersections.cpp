#include "intersection/intersections.hpp"

#include "intersection/triangle_pair.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unsupported/Eigen/BVH>

namespace drape::intersection {
namespace {

using Corners = std::array<int, 3>;
using Box = Eigen::AlignedBox3d;
using BoxTree = Eigen::KdBVH<double, 3, int>;

void requireSound(const Surface& surface) {
  if (!std::all_of(surface.positions.begin(), surface.positions.end(),
                   [](const Eigen::Vector3d& position) { return position.allFinite(); })) {
    throw std::invalid_argument("a position is not finite");
  }
  const auto count = static_cast<int>(surface.positions.size());
  for (const auto& [a, b, c] : surface.triangles) {
    if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= count || a == b || b == c || c == a) {
      throw std::invalid_argument("a triangle's indices do not fit");
    }
  }
}

Facet facetOf(const Surface& surface, const Corners& corners) {
  const auto at = [&](int i) { return surface.positions[static_cast<std::size_t>(i)]; };
  return {at(corners[0]), at(corners[1]), at(corners[2])};
}

/// The triangles of a surface, prepared for tests.
struct Facets {
  std::vector<Facet> list;
  std::vector<Box> boxes;
  BoxTree tree;  // of the indices

  explicit Facets(const Surface& surface) {
    requireSound(surface);
    list.reserve(surface.triangles.size());
    boxes.reserve(surface.triangles.size());
    for (const Corners& corners : surface.triangles) {
      list.push_back(facetOf(surface, corners));
      const auto& [a, b, c] = list.back().corners();
      boxes.push_back(Box(a, a).extend(b).extend(c));
    }
    std::vector<int> indices(list.size());
    std::iota(indices.begin(), indices.end(), 0);
    tree.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  }
  [[nodiscard]] const Facet& operator[](int i) const { return list[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Box& box(int i) const { return boxes[static_cast<std::size_t>(i)]; }
};

/// Collects the pairs whose boxes overlap and that `test` accepts; an Eigen intersector. Boxes are closed and compared
/// without rounding, so touching pairs are found.
template <typename Test>
struct PairSearch {
  const Facets& first;
  const Facets& second;
  const Test& test;
  std::vector<TrianglePair> pairs;

  static bool intersectVolumeVolume(const Box& a, const Box& b) { return a.intersects(b); }
  [[nodiscard]] bool intersectVolumeObject(const Box& a, int j) const { return a.intersects(second.box(j)); }
  [[nodiscard]] bool intersectObjectVolume(int i, const Box& b) const { return b.intersects(first.box(i)); }
  /// Returns false, which continues the search.
  bool intersectObjectObject(int i, int j) {
    if (first.box(i).intersects(second.box(j)) && test(i, j)) {
      pairs.push_back({i, j});
    }
    return false;
  }
};

/// The pairs of triangles of two surfaces that `test` accepts, sorted.
template <typename Test>
std::vector<TrianglePair> pairsOf(const Facets& first, const Facets& second, const Test& test) {
  PairSearch<Test> search{first, second, test, {}};
  Eigen::BVIntersect(first.tree, second.tree, search);
  std::sort(search.pairs.begin(), search.pairs.end());
  return std::move(search.pairs);
}

/// Moves the vertices that `corners` shares with `other` to the front, in the order of `other`. Returns their number.
int sharedFirst(Corners& corners, const Corners& other) {
  int shared = 0;
  for (const int vertex : other) {
    const auto begin = corners.begin() + shared;
    const auto found = std::find(begin, corners.end(), vertex);
    if (found != corners.end()) {
      std::iter_swap(begin, found);
      ++shared;
    }
  }
  return shared;
}

bool intersect(const Surface& surface, const Facets& facets, int i, int j) {
  Corners first = surface.triangles[static_cast<std::size_t>(i)];
  Corners second = surface.triangles[static_cast<std::size_t>(j)];
  const int shared = sharedFirst(first, second);
  if (shared == 0) {
    return meet(facets[i], facets[j]);
  }
  if (shared == 3) {
    return true;
  }
  sharedFirst(second, first);
  const Facet a = facetOf(surface, first);
  const Facet b = facetOf(surface, second);
  return shared == 1 ? meetBeyondCorner(a, b) : meetBeyondEdge(a, b);
}

}  // namespace

std::vector<TrianglePair> intersectingPairs(const Surface& surface) {
  const Facets facets(surface);
  // The search visits each pair in both orders.
  return pairsOf(facets, facets, [&](int i, int j) { return i < j && intersect(surface, facets, i, j); });
}

std::vector<TrianglePair> intersectingPairs(const Surface& first, const Surface& second) {
  const Facets a(first);
  const Facets b(second);
  return pairsOf(a, b, [&](int i, int j) { return meet(a[i], b[j]); });
}

std::vector<int> trianglesReaching(const Surface& surface, const std::array<Eigen::Vector3d, 3>& plane) {
  requireSound(surface);
  std::vector<bool> inFront;
  inFront.reserve(surface.positions.size());
  for (const Eigen::Vector3d& position : surface.positions) {
    inFront.push_back(orientation(plane[0], plane[1], plane[2], position) > 0);
  }
  std::vector<int> reaching;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Corners& corners = surface.triangles[t];
    if (!std::all_of(corners.begin(), corners.end(), [&](int v) { return inFront[static_cast<std::size_t>(v)]; })) {
      reaching.push_back(static_cast<int>(t));
    }
  }
  return reaching;
}

}  // namespace drape::intersection
