#include "scene/border_finder.hpp"

#include "messages/sentence_error.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace drape::scene {

BorderFinder::BorderFinder(const sim::ClothMesh& mesh, Naming named)
    : mesh_(mesh), named_(std::move(named)), borders_(findPieces(mesh).loops) {
  if (!named_) {
    named_ = [](int vertex) { return text::Sentence("vertex {}", vertex); };
  }
}

const BoundaryLoop& BorderFinder::borderWith(int vertex) const {
  const auto found = std::ranges::find_if(borders_, [&](const BoundaryLoop& border) {
    return std::ranges::find(border.vertices, vertex) != border.vertices.end();
  });
  if (found == borders_.end()) {
    const Vec3& at = mesh_.positions[vertex];
    throw messages::SentenceError(text::Sentence(
        "{} is not on an open border, so it cannot be sewn. It is at ({}) m; Drape numbers vertices as it "
        "reads them, which can differ from the file",
        named_(vertex), fmt::format("{:.3f}, {:.3f}, {:.3f}", at.x(), at.y(), at.z())));
  }
  return *found;
}

BorderPath BorderFinder::pathThrough(std::span<const int> points, bool isReversed) const {
  const BoundaryLoop& border = borderWith(points.front());
  if (points.size() == 1) {
    return wholeBorder(border.vertices, mesh_, points.front(), isReversed);
  }
  const auto between = points.size() == 3 ? std::optional(points[1]) : std::nullopt;
  const auto path = pathAlong(border.vertices, mesh_.positions, points.front(), points.back(), between);
  if (!path) {
    throw messages::SentenceError(
        text::Sentence("{} and {} are not on the same open border", named_(points.front()), named_(points.back())));
  }
  if (path->vertices.size() < 2) {
    throw messages::SentenceError(text::Sentence(
        "the path starts and ends at {}; give two points, or one for the whole border", named_(points.front())));
  }
  return *path;
}

int BorderFinder::nearestVertex(const Vec3& place, int first, int count) const {
  int nearest = -1;
  double distance = std::numeric_limits<double>::max();
  for (const BoundaryLoop& border : borders_) {
    for (const int vertex : border.vertices) {
      const double own = (mesh_.positions[vertex] - place).squaredNorm();
      if (vertex >= first && vertex < first + count && own < distance) {
        distance = own;
        nearest = vertex;
      }
    }
  }
  if (nearest < 0) {
    throw messages::SentenceError(text::Sentence("this cloth has no open border, so it cannot be sewn"));
  }
  return nearest;
}

std::vector<int> BorderFinder::nearestBorder(const Vec3& place) const {
  if (borders_.empty()) {
    throw messages::SentenceError(text::Sentence("this cloth has no open border, so it can have no elastic band"));
  }
  return borderWith(nearestVertex(place, 0, vertexCount())).vertices;
}

}  // namespace drape::scene
