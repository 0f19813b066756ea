#include "sim/simd/vertex_order.hpp"

#include "sim/fabric/fabric.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <span>
#include <utility>

namespace drape::sim::simd {
namespace {

constexpr int window = 128;

std::size_t degreeOf(const ClothModel& model, int vertex) {
  return model.springEnds[vertex].size();
}

/// Appends the vertices connected to `start`, breadth first, the neighbours of each vertex by ascending degree.
void appendBreadthFirst(const ClothModel& model, int start, std::vector<bool>& seen, std::vector<int>& order) {
  const auto less = [&](int a, int b) {
    return std::make_pair(degreeOf(model, a), a) < std::make_pair(degreeOf(model, b), b);
  };
  std::size_t next = order.size();
  order.push_back(start);
  seen[start] = true;
  while (next < order.size()) {
    const int vertex = order[next++];
    const auto first = static_cast<std::ptrdiff_t>(order.size());
    for (const SpringEnd& end : model.springEnds[vertex]) {
      if (!seen[end.neighbour]) {
        seen[end.neighbour] = true;
        order.push_back(end.neighbour);
      }
    }
    std::sort(order.begin() + first, order.end(), less);
  }
}

/// A pseudo-peripheral vertex: the last one of a breadth-first search, repeated once (George and Liu, 1979).
int peripheralVertex(const ClothModel& model, int start, const std::vector<bool>& seen) {
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<bool> visited = seen;
    std::vector<int> reached;
    appendBreadthFirst(model, start, visited, reached);
    start = reached.back();
  }
  return start;
}

std::vector<int> cuthillMcKee(const ClothModel& model) {
  std::vector<int> order;
  order.reserve(model.restPositions.size());
  std::vector<bool> seen(model.restPositions.size(), false);
  for (int vertex = 0; vertex < model.vertexCount(); ++vertex) {
    if (!seen[vertex]) {
      appendBreadthFirst(model, peripheralVertex(model, vertex, seen), seen, order);
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// What determines the work of a vertex: the number of its springs, and that of the vertices that bending connects it
/// with.
std::pair<std::size_t, Eigen::Index> workOf(const ClothModel& model, int vertex) {
  const bool bends = model.fabric && model.fabric->bends();
  return {degreeOf(model, vertex), bends ? model.fabric->bending.row(vertex).nonZeros() : 0};
}

void sortWindowsByWork(const ClothModel& model, std::vector<int>& order) {
  for (std::size_t begin = 0; begin < order.size(); begin += window) {
    const std::size_t end = std::min(order.size(), begin + window);
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                     order.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](int a, int b) { return workOf(model, a) < workOf(model, b); });
  }
}

}  // namespace

int bandwidth(const ClothModel& model, const std::vector<int>& order) {
  std::vector<int> index(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    index[order[k]] = static_cast<int>(k);
  }
  int widest = 0;
  for (const Spring& spring : model.springs) {
    widest = std::max(widest, std::abs(index[spring.a] - index[spring.b]));
  }
  return widest;
}

std::vector<int> stepOrder(const ClothModel& model) {
  std::vector<int> own(model.restPositions.size());
  std::iota(own.begin(), own.end(), 0);
  // A square sheet in row order has a bandwidth of about the square root of its number of vertices.
  const double small = 2.0 * std::sqrt(static_cast<double>(own.size())) + 16.0;
  if (static_cast<double>(bandwidth(model, own)) <= small) {
    return own;
  }
  std::vector<int> order = cuthillMcKee(model);
  sortWindowsByWork(model, order);
  return order;
}

}  // namespace drape::sim::simd
