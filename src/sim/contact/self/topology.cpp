#include "sim/contact/self/topology.hpp"

#include <algorithm>
#include <cstddef>

namespace drape {
namespace {

struct Side {
  int low = 0;
  int high = 0;
  int triangle = 0;
  int corner = 0;
  bool ascending = false;  // from low to high
};

std::vector<Side> sidesOf(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int from = triangles[t][c];
      const int to = triangles[t][(c + 1) % 3];
      if (from != to) {
        sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), static_cast<int>(c), from < to});
      }
    }
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& x, const Side& y) { return x.low != y.low ? x.low < y.low : x.high < y.high; });
  return sides;
}

}  // namespace

std::vector<std::array<int, 3>> trianglesAcross(const std::vector<Triangle>& triangles) {
  std::vector<std::array<int, 3>> across(triangles.size(), {-1, -1, -1});
  const std::vector<Side> sides = sidesOf(triangles);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) {
      ++end;
    }
    const Side& first = sides[begin];
    const Side& last = sides[end - 1];
    if (end - begin == 2 && first.ascending != last.ascending && first.triangle != last.triangle) {
      across[static_cast<std::size_t>(first.triangle)][static_cast<std::size_t>(first.corner)] = last.triangle;
      across[static_cast<std::size_t>(last.triangle)][static_cast<std::size_t>(last.corner)] = first.triangle;
    }
  }
  return across;
}

}  // namespace drape
