#include "scene/pin_selection.hpp"

#include "messages/error.hpp"
#include "scene/mesh_file.hpp"

#include <algorithm>

namespace drape::scene {
namespace {

int nearestVertex(const std::vector<Vec3>& positions, const Vec3& point) {
  const auto nearest = std::min_element(positions.begin(), positions.end(), [&](const Vec3& a, const Vec3& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
  return static_cast<int>(nearest - positions.begin());
}

template <typename Predicate>
void addWhere(const std::vector<Vec3>& positions, const Predicate& wanted, std::vector<int>& selected) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (wanted(positions[v])) {
      selected.push_back(static_cast<int>(v));
    }
  }
}

void addTop(const std::vector<Vec3>& positions, double fraction, std::vector<int>& selected) {
  const auto [lowest, highest] = std::minmax_element(positions.begin(), positions.end(),
                                                     [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  const double from = highest->y() - fraction * (highest->y() - lowest->y());
  addWhere(
      positions, [&](const Vec3& position) { return position.y() >= from; }, selected);
}

/// The pins that a grid knows by name. Throws InputError with the place of the table.
std::vector<int> namedPins(const PinSelection& pins, const GridLayout& grid) {
  try {
    return gridPins(pins, grid);
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(pins.where, error.what()));
  }
}

}  // namespace

std::vector<int> selectPins(const PinSelection& pins, const std::vector<Vec3>& restPositions, const GridLayout* grid) {
  std::vector<int> selected = pins.vertices;
  for (const int vertex : selected) {
    if (vertex < 0 || vertex >= static_cast<int>(restPositions.size())) {
      throw messages::InputError(placed(pins.whereVertices, "pins.vertices contains vertex " + std::to_string(vertex) +
                                                                ", but the vertices of the cloth are 0 to " +
                                                                std::to_string(restPositions.size() - 1)));
    }
  }
  if (grid != nullptr) {
    const std::vector<int> named = namedPins(pins, *grid);
    selected.insert(selected.end(), named.begin(), named.end());
  } else if (!pins.corners.empty() || !pins.edges.empty()) {
    throw messages::InputError(placed(
        pins.where, "pins.corners and pins.edges belong to a grid; for a mesh use vertices, nearest, boxes or top"));
  }
  for (const Vec3& point : pins.nearest) {
    selected.push_back(nearestVertex(restPositions, point));
  }
  for (const PinSelection::Box& box : pins.boxes) {
    addWhere(
        restPositions,
        [&](const Vec3& p) { return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all(); },
        selected);
  }
  if (pins.top) {
    addTop(restPositions, *pins.top, selected);
  }
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  return selected;
}

}  // namespace drape::scene
