#include "ui/vertex_selection.hpp"

#include "sim/model/disjoint_sets.hpp"
#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace drape::ui {
namespace {

constexpr double clickDistance = 5.0;  // a shorter drag is a click [window units]

/// The vertex among `candidates` whose place in the window is nearest; -1 if there is none.
int nearestOf(std::span<const int> candidates, const Vec2& place, const session::Snapshot& snapshot,
              const VertexSelection::Projection& toWindow) {
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (const int vertex : candidates) {
    const double each = (toWindow(snapshot.positions[vertex]) - place).squaredNorm();
    if (each < distance) {
      distance = each;
      nearest = vertex;
    }
  }
  return nearest;
}

std::vector<int> allVertices(const session::Snapshot& snapshot) {
  std::vector<int> all(snapshot.positions.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<int>(i);
  }
  return all;
}

std::vector<int> inside(const UiRect& rectangle, const session::Snapshot& snapshot,
                        const VertexSelection::Projection& toWindow) {
  std::vector<int> found = allVertices(snapshot);
  std::erase_if(found, [&](int vertex) { return !rectangle.contains(toWindow(snapshot.positions[vertex])); });
  return found;
}

std::vector<int> changed(const std::vector<int>& before, const std::vector<int>& found,
                         VertexSelection::Change change) {
  std::vector<int> result;
  switch (change) {
    case VertexSelection::Change::Replace:
      return found;
    case VertexSelection::Change::Add:
      std::ranges::set_union(before, found, std::back_inserter(result));
      break;
    case VertexSelection::Change::Remove:
      std::ranges::set_difference(before, found, std::back_inserter(result));
      break;
  }
  return result;
}

}  // namespace

void VertexSelection::press(const Vec2& at, Change change) {
  start_ = at;
  end_ = at;
  change_ = change;
}

void VertexSelection::drag(const Vec2& at) {
  end_ = at;
}

UiRect VertexSelection::rectangle() const {
  const Vec2 low = start_->cwiseMin(end_);
  const Vec2 size = start_->cwiseMax(end_) - low;
  return {low.x(), low.y(), size.x(), size.y()};
}

void VertexSelection::release(const session::Snapshot& snapshot, const Projection& toWindow) {
  if (!start_) {
    return;
  }
  follow(snapshot);
  const bool isClick = (end_ - *start_).norm() < clickDistance;
  std::vector<int> found;
  if (mode_ == SelectionMode::Border) {
    found = borderNear(end_, snapshot, toWindow);
  } else if (!isClick) {
    found = inside(rectangle(), snapshot, toWindow);
  } else if (const int vertex = nearestOf(allVertices(snapshot), end_, snapshot, toWindow); vertex >= 0) {
    found = {vertex};
  }
  selected_ = changed(selected_, found, change_);
  start_.reset();
}

void VertexSelection::follow(const session::Snapshot& snapshot) {
  if (scene_.lock() != snapshot.scene) {
    selected_.clear();
    start_.reset();
    scene_ = snapshot.scene;
  }
}

SelectionView VertexSelection::view(const session::Snapshot& snapshot, const Projection& toWindow) const {
  SelectionView result{.mode = mode_, .rectangle = std::nullopt, .vertices = selected_, .points = {}, .pinned = 0};
  if (start_ && mode_ == SelectionMode::Rectangle) {
    result.rectangle = rectangle();
  }
  for (const int vertex : selected_) {
    result.points.push_back(toWindow(snapshot.positions[vertex]));
    result.pinned += snapshot.model->pinned[vertex] ? 1 : 0;
  }
  return result;
}

std::vector<int> borderNear(const Vec2& place, const session::Snapshot& snapshot,
                            const VertexSelection::Projection& toWindow) {
  const std::size_t count = snapshot.positions.size();
  sim::DisjointSets sets(count);
  std::vector<bool> isBorder(count, false);
  for (const sim::MeshEdge& edge : sim::boundaryEdges(sim::edgesOf(snapshot.model->triangles, count))) {
    sets.join(edge.a, edge.b);
    isBorder[edge.a] = true;
    isBorder[edge.b] = true;
  }
  std::vector<int> border = allVertices(snapshot);
  std::erase_if(border, [&](int vertex) { return !isBorder[vertex]; });
  const int nearest = nearestOf(border, place, snapshot, toWindow);
  if (nearest >= 0) {
    const int root = sets.root(nearest);
    std::erase_if(border, [&](int vertex) { return sets.root(vertex) != root; });
  }
  return border;
}

session::SetPinsCommand pinsWith(const session::Snapshot& snapshot, std::span<const int> vertices, bool pinned) {
  std::vector<bool> pins = snapshot.model->pinned;
  for (const int vertex : vertices) {
    pins[vertex] = pinned;
  }
  session::SetPinsCommand command;
  for (std::size_t v = 0; v < pins.size(); ++v) {
    if (pins[v]) {
      command.vertices.push_back(static_cast<int>(v));
    }
  }
  return command;
}

}  // namespace drape::ui
