#include "ui/border_picker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace drape::ui {
namespace {

/// The turn of a border from which a vertex is a corner [rad].
constexpr double cornerAngle = 35.0 * std::numbers::pi / 180.0;

/// A border that is farther from the mouse by up to this can be in front of the nearest one [window units].
constexpr double samePlace = 3.0;

bool isCorner(const Vec3& before, const Vec3& here, const Vec3& after) {
  const Vec3 in = here - before;
  const Vec3 out = after - here;
  return std::atan2(in.cross(out).norm(), in.dot(out)) > cornerAngle;
}

std::vector<std::size_t> cornersOf(const scene::BoundaryLoop& border, std::span<const Vec3> rest) {
  std::vector<std::size_t> corners;
  const std::size_t count = border.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (isCorner(rest[border.vertices[(i + count - 1) % count]], rest[border.vertices[i]],
                 rest[border.vertices[(i + 1) % count]])) {
      corners.push_back(i);
    }
  }
  return corners;
}

/// A border near the mouse.
struct NearBorder {
  BorderSpot spot = {};
  double distance = 0.0;  // from the mouse [window units]
  double depth = 0.0;     // behind the plane of the eye [m]
};

/// The spot of a border that is nearest to a place.
NearBorder nearestOn(const scene::BoundaryLoop& border, const Vec2& place, std::span<const Vec3> positions,
                     const GizmoPicture& picture) {
  NearBorder nearest{.distance = std::numeric_limits<double>::infinity()};
  const std::size_t count = border.vertices.size();
  Vec2 from = picture.toWindow(positions[border.vertices.front()]);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Vec2 to = picture.toWindow(positions[border.vertices[next]]);
    const Vec2 along = to - from;
    const double square = along.squaredNorm();
    const double share = square > 0.0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0.0;
    const double distance = (place - from - share * along).norm();
    if (distance < nearest.distance) {
      const std::size_t vertex = share < 0.5 ? i : next;
      nearest = {{0, i, vertex}, distance, -positions[border.vertices[vertex]].dot(picture.back())};
    }
    from = to;
  }
  return nearest;
}

}  // namespace

BorderPicker::BorderPicker(const scene::Scene& scene)
    : scene_(scene), borders_(scene::findPieces({scene.model->restPositions, scene.model->triangles}).loops) {
  for (const scene::BoundaryLoop& border : borders_) {
    corners_.push_back(cornersOf(border, scene.model->restPositions));
  }
}

std::optional<BorderSpot> BorderPicker::at(const Vec2& place, double maxDistance, std::span<const Vec3> positions,
                                           const GizmoPicture& picture) const {
  std::vector<NearBorder> near;
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    near.push_back(nearestOn(borders_[i], place, positions, picture));
    near.back().spot.border = i;
  }
  std::erase_if(near, [&](const NearBorder& each) { return each.distance > maxDistance; });
  if (near.empty()) {
    return std::nullopt;
  }
  const double nearest = std::ranges::min_element(near, {}, &NearBorder::distance)->distance;
  std::erase_if(near, [&](const NearBorder& each) { return each.distance > nearest + samePlace; });
  return std::ranges::min_element(near, {}, &NearBorder::depth)->spot;
}

double BorderPicker::lengthOf(std::span<const int> vertices, bool isClosed) const {
  const std::vector<Vec3>& rest = scene_.model->restPositions;
  double length = isClosed ? (rest[vertices.front()] - rest[vertices.back()]).norm() : 0.0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    length += (rest[vertices[i]] - rest[vertices[i - 1]]).norm();
  }
  return length;
}

std::vector<int> BorderPicker::forward(std::size_t border, std::size_t from, std::size_t to) const {
  const std::vector<int>& vertices = borders_[border].vertices;
  std::vector<int> path{vertices[from]};
  for (std::size_t i = from; i != to;) {
    i = (i + 1) % vertices.size();
    path.push_back(vertices[i]);
  }
  return path;
}

/// A part is described by its ends and a vertex between them, so that its way along the border is certain.
PickedBorder BorderPicker::picked(std::vector<int> vertices, bool isClosed) const {
  const scene::ClothPart& cloth = scene::clothWith(vertices.front(), scene_.cloths);
  PickedBorder result;
  result.description.cloth = cloth.name;
  std::vector<int>& points = result.description.vertices;
  points.push_back(vertices.front() - cloth.firstVertex);
  if (!isClosed && vertices.size() > 2) {
    points.push_back(vertices[vertices.size() / 2] - cloth.firstVertex);
  }
  if (!isClosed) {
    points.push_back(vertices.back() - cloth.firstVertex);
  }
  result.length = lengthOf(vertices, isClosed);
  result.vertices = std::move(vertices);
  result.isClosed = isClosed;
  return result;
}

PickedBorder BorderPicker::whole(const BorderSpot& spot) const {
  std::vector<int> vertices = borders_[spot.border].vertices;
  std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(spot.vertex), vertices.end());
  return picked(std::move(vertices), true);
}

PickedBorder BorderPicker::betweenCorners(const BorderSpot& spot) const {
  const std::vector<std::size_t>& corners = corners_[spot.border];
  if (corners.size() < 2) {
    return whole(spot);
  }
  const auto next = std::ranges::upper_bound(corners, spot.edge);
  const std::size_t end = next == corners.end() ? corners.front() : *next;
  const std::size_t begin = next == corners.begin() ? corners.back() : *std::prev(next);
  return picked(forward(spot.border, begin, end), false);
}

std::vector<int> BorderPicker::middles() const {
  std::vector<int> middles;
  for (std::size_t border = 0; border < borders_.size(); ++border) {
    const std::size_t parts = std::max<std::size_t>(corners_[border].size(), 1);
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t edge = corners_[border].empty() ? 0 : corners_[border][part];
      const std::vector<int> vertices = betweenCorners({border, edge, edge}).vertices;
      middles.push_back(vertices[vertices.size() / 2]);
    }
  }
  return middles;
}

std::optional<PickedBorder> BorderPicker::between(const BorderSpot& from, const BorderSpot& to, bool longer) const {
  if (from.border != to.border || from.vertex == to.vertex) {
    return std::nullopt;
  }
  std::vector<int> ahead = forward(from.border, from.vertex, to.vertex);
  std::vector<int> back = forward(from.border, to.vertex, from.vertex);
  std::ranges::reverse(back);
  const bool aheadIsShorter = lengthOf(ahead, false) <= lengthOf(back, false);
  return picked(std::move(aheadIsShorter != longer ? ahead : back), false);
}

}  // namespace drape::ui
