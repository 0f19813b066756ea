#include "intersection/intersections.hpp"

#include "intersection/box_tree.hpp"
#include "intersection/triangle_pair.hpp"

#include <algorithm>
#include <stdexcept>

namespace drape {
namespace {

using Corners = std::array<int, 3>;

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
  BoxTree tree;

  explicit Facets(const Surface& surface) : list(listOf(surface)), tree(boxesOf(list)) {}
  [[nodiscard]] const Facet& operator[](int i) const { return list[static_cast<std::size_t>(i)]; }

  static std::vector<Facet> listOf(const Surface& surface) {
    requireSound(surface);
    std::vector<Facet> facets;
    facets.reserve(surface.triangles.size());
    for (const Corners& corners : surface.triangles) {
      facets.push_back(facetOf(surface, corners));
    }
    return facets;
  }

  static std::vector<Box> boxesOf(const std::vector<Facet>& facets) {
    std::vector<Box> boxes;
    boxes.reserve(facets.size());
    for (const Facet& facet : facets) {
      const auto& [a, b, c] = facet.corners();
      boxes.push_back(Box(a, a).extend(b).extend(c));
    }
    return boxes;
  }
};

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
  std::vector<TrianglePair> pairs;
  facets.tree.forEachPair([&](int i, int j) {
    if (intersect(surface, facets, i, j)) {
      pairs.push_back({i, j});
    }
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<TrianglePair> intersectingPairs(const Surface& first, const Surface& second) {
  const Facets a(first);
  const Facets b(second);
  std::vector<TrianglePair> pairs;
  a.tree.forEachPair(b.tree, [&](int i, int j) {
    if (meet(a[i], b[j])) {
      pairs.push_back({i, j});
    }
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
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

}  // namespace drape
