#include "scene/seam_matching.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::scene {
namespace {

double lengthOf(std::span<const int> vertices, std::span<const Vec3> positions) {
  double length = 0.0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    length += (positions[vertices[i]] - positions[vertices[i - 1]]).norm();
  }
  return length;
}

/// The share of the length of a path up to each of its vertices [-].
std::vector<double> sharesOf(const BorderPath& path, std::span<const Vec3> positions) {
  std::vector<double> shares{0.0};
  const std::size_t count = path.vertices.size();
  for (std::size_t i = 1; i < count + (path.isClosed ? 1 : 0); ++i) {
    shares.push_back(shares.back() + (positions[path.vertices[i % count]] - positions[path.vertices[i - 1]]).norm());
  }
  const double length = shares.back();
  std::ranges::transform(shares, shares.begin(), [&](double share) { return length > 0.0 ? share / length : 0.0; });
  shares.resize(count);
  return shares;
}

/// The vertices from one index to another, in the order of the border.
std::vector<int> forward(std::span<const int> border, std::size_t first, std::size_t last) {
  std::vector<int> path{border[first]};
  for (std::size_t i = first; i != last;) {
    i = (i + 1) % border.size();
    path.push_back(border[i]);
  }
  return path;
}

/// Whether a triangle has a side from one vertex to the other.
bool hasSide(std::span<const Triangle> triangles, int from, int to) {
  return std::ranges::any_of(triangles, [&](const Triangle& triangle) {
    return (triangle[0] == from && triangle[1] == to) || (triangle[1] == from && triangle[2] == to) ||
           (triangle[2] == from && triangle[0] == to);
  });
}

}  // namespace

std::optional<BorderPath> pathAlong(std::span<const int> border, std::span<const Vec3> positions, int first, int last,
                                    std::optional<int> between) {
  const auto begin = std::ranges::find(border, first);
  const auto end = std::ranges::find(border, last);
  if (begin == border.end() || end == border.end()) {
    return std::nullopt;
  }
  const auto from = static_cast<std::size_t>(begin - border.begin());
  const auto to = static_cast<std::size_t>(end - border.begin());
  BorderPath path{.vertices = forward(border, from, to)};
  std::vector<int> back = forward(border, to, from);
  std::ranges::reverse(back);
  if (between) {
    const auto contains = [&](const std::vector<int>& way) { return std::ranges::find(way, *between) != way.end(); };
    if (!contains(path.vertices) && !contains(back)) {
      return std::nullopt;
    }
    path.vertices = contains(path.vertices) ? path.vertices : back;
  } else if (lengthOf(back, positions) < lengthOf(path.vertices, positions)) {
    path.vertices = std::move(back);
  }
  return path;
}

BorderPath wholeBorder(std::span<const int> border, const sim::ClothMesh& mesh, int start, bool reversed) {
  BorderPath path{.vertices = {border.begin(), border.end()}, .isClosed = true};
  if (hasSide(mesh.triangles, border[0], border[1]) == reversed) {
    std::ranges::reverse(path.vertices);
  }
  std::ranges::rotate(path.vertices, std::ranges::find(path.vertices, start));
  return path;
}

std::vector<sim::SeamPair> matched(const BorderPath& from, const BorderPath& to, std::span<const Vec3> positions) {
  const bool swaps = from.vertices.size() > to.vertices.size();
  const BorderPath& fewer = swaps ? to : from;
  const BorderPath& more = swaps ? from : to;
  const std::vector<double> shares = sharesOf(fewer, positions);
  const std::vector<double> others = sharesOf(more, positions);
  std::vector<sim::SeamPair> pairs;
  std::size_t next = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const std::size_t last = others.size() - (shares.size() - i);  // leaves one for each of those that follow
    std::size_t nearest = next;
    for (std::size_t k = next; k <= last; ++k) {
      nearest = std::abs(others[k] - shares[i]) < std::abs(others[nearest] - shares[i]) ? k : nearest;
    }
    const int own = fewer.vertices[i];
    const int other = more.vertices[nearest];
    pairs.push_back(swaps ? sim::SeamPair{other, own} : sim::SeamPair{own, other});
    next = nearest + 1;
  }
  return pairs;
}

}  // namespace drape::scene
