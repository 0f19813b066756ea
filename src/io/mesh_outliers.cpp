#include "io/mesh_outliers.hpp"

#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <cstddef>

namespace drape::io {
namespace {

/// Outliers are at most one vertex in this many. More are a second object.
constexpr std::size_t verticesPerOutlier = 20;

/// Outliers are at least this many times farther from the centre than all other vertices.
constexpr double minGap = 20.0;

/// Below this number of vertices, a long thin mesh looks like an outlier.
constexpr std::size_t minOthers = 10;

std::vector<int> usedVertices(std::size_t count, const std::vector<Triangle>& triangles) {
  std::vector<bool> used(count, false);
  for (const Triangle& triangle : triangles) {
    for (const int vertex : triangle) {
      used[vertex] = true;
    }
  }
  std::vector<int> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    if (used[i]) {
      vertices.push_back(static_cast<int>(i));
    }
  }
  return vertices;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec3 medianPosition(const std::vector<Vec3>& positions, const std::vector<int>& vertices) {
  Vec3 middle;
  std::vector<double> values(vertices.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(vertices.begin(), vertices.end(), values.begin(),
                   [&](int vertex) { return positions[vertex][axis]; });
    middle[axis] = median(values);
  }
  return middle;
}

/// The first distance, in ascending order, that is much larger than the one before; 0 when there is none.
double firstFarDistance(const std::vector<double>& ascending, std::size_t maxOutliers) {
  for (std::size_t i = ascending.size() - maxOutliers; i < ascending.size(); ++i) {
    if (i > 0 && ascending[i] > minGap * ascending[i - 1] && ascending[i - 1] > 0.0) {
      return ascending[i];
    }
  }
  return 0.0;
}

}  // namespace

std::vector<int> findOutliers(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  const std::vector<int> vertices = usedVertices(positions.size(), triangles);
  if (vertices.size() <= minOthers) {
    return {};
  }
  const Vec3 middle = medianPosition(positions, vertices);
  std::vector<double> distances(vertices.size());
  std::transform(vertices.begin(), vertices.end(), distances.begin(),
                 [&](int vertex) { return (positions[vertex] - middle).norm(); });
  std::vector<double> ascending = distances;
  const std::size_t maxOutliers = std::max<std::size_t>(1, vertices.size() / verticesPerOutlier);
  // Only the largest distances must be sorted.
  const auto kept = ascending.end() - static_cast<std::ptrdiff_t>(maxOutliers + 1);
  std::nth_element(ascending.begin(), kept, ascending.end());
  std::sort(kept, ascending.end());
  const double far = firstFarDistance(ascending, maxOutliers);
  std::vector<int> outliers;
  for (std::size_t i = 0; far > 0.0 && i < vertices.size(); ++i) {
    if (distances[i] >= far) {
      outliers.push_back(vertices[i]);
    }
  }
  return outliers;
}

double medianEdge(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  std::vector<double> lengths;
  lengths.reserve(3 * triangles.size());
  sim::forEachSide(triangles, [&](int from, int to) {
    const double length = (positions[from] - positions[to]).norm();
    if (length > 0.0) {
      lengths.push_back(length);
    }
  });
  return lengths.empty() ? 0.0 : median(lengths);
}

}  // namespace drape::io
