#include "sim/contact/exact/pair_gap.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>
#include <limits>

namespace drape::sim::contact {

namespace {

/// Squared sine of an angle of a triangle below which it is a sliver: rounding moves the closest point inside a sliver
/// farther than its height.
constexpr double thin = 1e-10;

/// Bound of the rounding error of a product of a unit vector with an offset, relative to the sum of the offset's
/// coordinates: half an ulp of the subtraction, the products and the sums, and as much again for the normal's length.
constexpr double productRounding = 4.0 * std::numeric_limits<double>::epsilon();

/// Smallest ratio of a distance to offsets and motions for which their rounding does not matter to comesWithin.
constexpr double minRatioToSize = 1e-12;

Vec3 nearestOnBorder(const Vec3& point, const Corners& triangle) {
  double best = std::numeric_limits<double>::infinity();
  Vec3 weights = Vec3::UnitX();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vec3 side = triangle[next] - triangle[k];
    const double along = nearestOnSegment(point, triangle[k], triangle[next]);
    const double squared = (triangle[k] + along * side - point).squaredNorm();
    if (squared < best) {
      best = squared;
      weights = Vec3::Zero();
      weights[k] = 1.0 - along;
      weights[next] = along;
    }
  }
  return weights;
}

Vec3 nearestWeights(const Vec3& point, const Corners& triangle) {
  const Vec3 weights = nearestOnTriangle(point, triangle);
  const Vec3 first = triangle[1] - triangle[0];
  const Vec3 second = triangle[2] - triangle[0];
  const bool isSliver = first.cross(second).squaredNorm() <= thin * first.squaredNorm() * second.squaredNorm();
  return isSliver && weights.minCoeff() > 0.0 ? nearestOnBorder(point, triangle) : weights;
}

/// The time for which the separation of a pair along a normal stays at least `distance`. Infinity: without end.
double timeToSeparation(double distance, const Vec3& normal, const PairVertices& vertices, std::span<const Vec3> at,
                        std::span<const Vec3> velocities) {
  double time = std::numeric_limits<double>::infinity();
  for (const int i : vertices.first()) {
    for (const int k : vertices.second()) {
      const double closing = normal.dot(velocities[k] - velocities[i]);
      if (closing > 0.0) {
        time = std::min(time, (normal.dot(at[i] - at[k]) - distance) / closing);
      }
    }
  }
  return time;
}

}  // namespace

PairVertices verticesOf(const FeatureMesh& mesh, const FeaturePair& pair) {
  if (pair.edges) {
    const MeshEdge& first = mesh.edges.edges[pair.first];
    const MeshEdge& second = mesh.edges.edges[pair.second];
    return {{first.a, first.b, second.a, second.b}, 2};
  }
  const Triangle& triangle = mesh.triangles[pair.second];
  return {{pair.first, triangle[0], triangle[1], triangle[2]}, 1};
}

PairGap gapOf(const PairVertices& vertices, std::span<const Vec3> positions) {
  const auto& [a, b, c, d] = vertices.all;
  PairGap gap;
  if (vertices.firstCount == 2) {
    const SegmentPair nearest = nearestOfSegments({positions[a], positions[b]}, {positions[c], positions[d]});
    gap.weights = {1.0 - nearest.first, nearest.first, nearest.second - 1.0, -nearest.second};
  } else {
    const Vec3 nearest = nearestWeights(positions[a], {positions[b], positions[c], positions[d]});
    gap.weights = {1.0, -nearest[0], -nearest[1], -nearest[2]};
  }
  // Offsets from the first vertex, so that cloth far from the origin keeps its digits.
  const Vec3 offset = gap.weights[1] * (positions[b] - positions[a]) + gap.weights[2] * (positions[c] - positions[a]) +
                      gap.weights[3] * (positions[d] - positions[a]);
  gap.distance = offset.norm();
  if (gap.distance > 0.0) {
    gap.normal = offset / gap.distance;
  }
  return gap;
}

bool comesWithin(double distance, const PairVertices& vertices, std::span<const Vec3> start,
                 std::span<const Vec3> end) {
  std::array<Vec3, 4> from, move, at;
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    from[k] = start[vertices.all[k]] - start[vertices.all[0]];
    move[k] = end[vertices.all[k]] - start[vertices.all[k]];
    mean += 0.25 * move[k];
  }
  double first = 0.0;
  double second = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    move[k] -= mean;
    double& speed = k < vertices.firstCount ? first : second;
    speed = std::max(speed, move[k].norm());
  }
  const double speed = first + second;  // the distance changes by at most this in the whole step
  const double near = 0.5 * (1.0 + approachSlack) * distance;
  double size = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    size = std::max({size, from[k].norm(), move[k].norm()});
  }
  if (!(distance > minRatioToSize * size)) {
    return true;
  }
  const double maxRounds = speed / (near - distance) + 2.0;
  const PairVertices local{{0, 1, 2, 3}, vertices.firstCount};
  double time = 0.0;  // in steps
  for (double round = 0.0; round < maxRounds; round += 1.0) {
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = from[k] + time * move[k];
    }
    const PairGap gap = gapOf(local, at);
    const double separation = separationAlong(gap.normal, local, at);  // at most the distance
    if (!(separation > near)) {
      return true;
    }
    time += std::max((separation - distance) / speed, timeToSeparation(distance, gap.normal, local, at, move));
    if (time >= 1.0) {
      return false;
    }
  }
  return true;
}

PairExtents extentsOf(const PairVertices& vertices, const Vec3& normal, const Vec3& origin,
                      std::span<const Vec3> positions) {
  PairExtents extents{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const int v : vertices.first()) {
    extents.firstLow = std::min(extents.firstLow, normal.dot(positions[v] - origin));
  }
  for (const int v : vertices.second()) {
    extents.secondHigh = std::max(extents.secondHigh, normal.dot(positions[v] - origin));
  }
  return extents;
}

double roundingOf(const PairVertices& vertices, std::span<const Vec3> positions) {
  double sum = 0.0;
  for (const int v : vertices.all) {
    sum = std::max(sum, (positions[v] - positions[vertices.all[0]]).lpNorm<1>());
  }
  return 2.0 * productRounding * sum + std::numeric_limits<double>::min();
}

double separationAlong(const Vec3& normal, const PairVertices& vertices, std::span<const Vec3> positions) {
  const PairExtents extents = extentsOf(vertices, normal, positions[vertices.all[0]], positions);
  return extents.firstLow - extents.secondHigh - roundingOf(vertices, positions);
}

}  // namespace drape::sim::contact
