#include "sim/adaptive/coarse_levels.hpp"

#include "sim/adaptive/tuning.hpp"
#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace drape::sim::adaptive {
namespace {

/// For each vertex its neighbours along the boundary. A boundary edge belongs to one triangle.
using BoundaryNeighbours = std::vector<std::vector<int>>;

BoundaryNeighbours boundaryOf(const ClothModel& model) {
  BoundaryNeighbours boundary(model.restPositions.size());
  for (const auto& [a, b] : boundaryEdges(edgesOf(model.triangles, boundary.size()))) {
    boundary[a].push_back(b);
    boundary[b].push_back(a);
  }
  return boundary;
}

/// The boundary of the aggregates, from the boundary of the finer level.
BoundaryNeighbours boundaryOf(const BoundaryNeighbours& finer, const std::vector<int>& aggregateOf, std::size_t count) {
  BoundaryNeighbours boundary(count);
  for (std::size_t i = 0; i < finer.size(); ++i) {
    for (const int j : finer[i]) {
      if (aggregateOf[i] != aggregateOf[j]) {
        boundary[aggregateOf[i]].push_back(aggregateOf[j]);
      }
    }
  }
  for (std::vector<int>& ends : boundary) {
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  }
  return boundary;
}

/// The order in which roots are chosen: first along the boundary, starting at the pins, then inwards ring by ring.
/// Aggregates then lie in straight rows along free edges.
class VisitOrder {
 public:
  VisitOrder(const ClothModel& model, const BoundaryNeighbours& boundary)
      : model_(model), boundary_(boundary), seen_(boundary.size(), false) {
    visitBoundary([&](std::size_t i) { return model.pinned[i]; });
    visitBoundary([&](std::size_t i) { return !boundary[i].empty(); });
    visitInterior(0);
    for (std::size_t i = 0; i < seen_.size(); ++i) {  // vertices that are not connected to a boundary or a pin
      const std::size_t first = order_.size();
      add(i);
      visitInterior(first);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  void add(std::size_t i) {
    if (!seen_[i]) {
      seen_[i] = true;
      order_.push_back(i);
    }
  }

  /// Visits the vertices with `isStart`, and from each the boundary.
  template <typename IsStart>
  void visitBoundary(IsStart&& isStart) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (isStart(i) && !seen_[i]) {
        std::size_t next = order_.size();
        add(i);
        for (; next < order_.size(); ++next) {
          for (const int j : boundary_[order_[next]]) {
            add(static_cast<std::size_t>(j));
          }
        }
      }
    }
  }

  void visitInterior(std::size_t next) {
    for (; next < order_.size(); ++next) {
      for (const SpringEnd& end : model_.springEnds[order_[next]]) {
        add(static_cast<std::size_t>(end.neighbour));
      }
    }
  }

  const ClothModel& model_;
  const BoundaryNeighbours& boundary_;
  std::vector<bool> seen_;
  std::vector<std::size_t> order_;
};

/// Assigns each vertex to an aggregate. The roots are a maximal independent set; every other vertex joins the nearest
/// adjacent root, on the boundary a root on the boundary if there is one.
class Aggregation {
 public:
  Aggregation(const ClothModel& model, const BoundaryNeighbours& boundary)
      : model_(model), boundary_(boundary), isRoot_(boundary.size(), false) {
    const std::vector<std::size_t> order = VisitOrder(model, boundary).order();
    std::vector<bool> taken(boundary.size(), false);
    for (const std::size_t i : order) {
      if (!taken[i]) {
        isRoot_[i] = true;
        for (const SpringEnd& end : model.springEnds[i]) {
          taken[end.neighbour] = true;
        }
      }
    }
    for (const std::size_t i : order) {
      isRoot_[i] = isRoot_[i] || rootOf(i) < 0;
    }
    number();
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::vector<int> take() { return std::move(aggregateOf_); }

 private:
  /// Numbers the aggregates in the order of their roots, so that a regular cloth has regular aggregates.
  void number() {
    aggregateOf_.assign(isRoot_.size(), -1);
    for (std::size_t i = 0; i < isRoot_.size(); ++i) {
      if (isRoot_[i]) {
        aggregateOf_[i] = count_++;
      }
    }
    for (std::size_t i = 0; i < isRoot_.size(); ++i) {
      if (!isRoot_[i]) {
        aggregateOf_[i] = aggregateOf_[rootOf(i)];
      }
    }
  }

  /// The root that a vertex joins; -1 if no adjacent root has the same pinned state.
  [[nodiscard]] int rootOf(std::size_t i) const {
    int nearest = -1;
    double distance = std::numeric_limits<double>::max();
    const auto consider = [&](int neighbour) {
      const double length = (model_.restPositions[i] - model_.restPositions[neighbour]).norm();
      if (isRoot_[neighbour] && model_.pinned[neighbour] == model_.pinned[i] && length < distance) {
        nearest = neighbour;
        distance = length;
      }
    };
    std::for_each(boundary_[i].begin(), boundary_[i].end(), consider);
    if (nearest < 0) {
      for (const SpringEnd& end : model_.springEnds[i]) {
        consider(end.neighbour);
      }
    }
    return nearest;
  }

  const ClothModel& model_;
  const BoundaryNeighbours& boundary_;
  std::vector<bool> isRoot_;
  std::vector<int> aggregateOf_;
  int count_ = 0;
};

/// Springs between aggregates whose members springs connect, unless both aggregates are pinned.
std::vector<Spring> springsBetween(const ClothModel& model, const std::vector<int>& aggregateOf,
                                   const ClothModel& aggregates) {
  std::vector<std::pair<int, int>> pairs;
  for (const Spring& spring : model.springs) {
    const int a = aggregateOf[spring.a];
    const int b = aggregateOf[spring.b];
    const bool bothPinned = aggregates.pinned[a] && aggregates.pinned[b];
    if (a != b && !bothPinned) {
      pairs.emplace_back(std::minmax(a, b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Spring> springs;
  for (const auto& [a, b] : pairs) {
    const Vec3 offset = aggregates.restPositions[b] - aggregates.restPositions[a];
    springs.push_back({a, b, offset.norm()});
  }
  return springs;
}

CoarseLevel coarserLevel(const ClothModel& model, const BoundaryNeighbours& boundary) {
  Aggregation aggregation(model, boundary);
  const auto count = static_cast<std::size_t>(aggregation.count());
  CoarseLevel level;
  level.aggregateOf = aggregation.take();
  auto aggregates = std::make_shared<ClothModel>();
  aggregates->restPositions.assign(count, Vec3::Zero());
  aggregates->vertexMass.assign(count, 0.0);
  aggregates->vertexArea.assign(count, 0.0);
  aggregates->pinned.assign(count, false);
  aggregates->vertexTriangles = trianglesOfVertices({}, count);
  for (std::size_t i = 0; i < level.aggregateOf.size(); ++i) {
    const int g = level.aggregateOf[i];
    aggregates->restPositions[g] += model.vertexMass[i] * model.restPositions[i];
    aggregates->vertexMass[g] += model.vertexMass[i];
    aggregates->pinned[g] = model.pinned[i];
  }
  for (std::size_t g = 0; g < count; ++g) {
    aggregates->restPositions[g] /= aggregates->vertexMass[g];
  }
  aggregates->springs = springsBetween(model, level.aggregateOf, *aggregates);
  aggregates->springEnds = springEndsOf(aggregates->springs, count);
  level.cloth = std::move(aggregates);
  return level;
}

}  // namespace

std::vector<CoarseLevel> buildCoarseLevels(const ClothModel& model) {
  std::vector<CoarseLevel> levels;
  const ClothModel* finer = &model;
  BoundaryNeighbours boundary = boundaryOf(model);
  while (finer->vertexCount() > tuning.minAggregates) {
    CoarseLevel level = coarserLevel(*finer, boundary);
    if (level.cloth->springs.empty() || level.cloth->vertexCount() == finer->vertexCount()) {
      break;
    }
    boundary = boundaryOf(boundary, level.aggregateOf, level.cloth->restPositions.size());
    levels.push_back(std::move(level));
    finer = levels.back().cloth.get();
  }
  return levels;
}

}  // namespace drape::sim::adaptive
