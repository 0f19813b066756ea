#include "sim/motion/unfolding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape::sim {
namespace {

/// Thickness below which points count as flat, as a fraction of the rest shape's diagonal.
constexpr double flatFraction = 1e-9;
/// The fraction of the rest shape that is added.
constexpr double addedFraction = 1e-6;

/// The point with the largest `distance`.
template <typename Distance>
Vec3 pointOfMaxDistance(std::span<const Vec3> points, const Distance& distance) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
}

}  // namespace

int dimensionsOf(std::span<const Vec3> points, double thickness) {
  if (points.empty()) {
    return 0;
  }
  const Vec3& origin = points.front();
  const auto fromOrigin = [&](const Vec3& p) { return (p - origin).norm(); };
  const Vec3 end = pointOfMaxDistance(points, fromOrigin);
  if (!(fromOrigin(end) > thickness)) {
    return 0;
  }
  const Vec3 along = (end - origin).normalized();
  const auto fromLine = [&](const Vec3& p) { return (p - origin - along.dot(p - origin) * along).norm(); };
  const Vec3 side = pointOfMaxDistance(points, fromLine);
  if (!(fromLine(side) > thickness)) {
    return 1;
  }
  const Vec3 normal = along.cross(side - origin).normalized();
  const auto fromPlane = [&](const Vec3& p) { return std::abs(normal.dot(p - origin)); };
  return fromPlane(pointOfMaxDistance(points, fromPlane)) > thickness ? 3 : 2;
}

bool makeUnfoldable(const ClothModel& model, ClothState& state) {
  const double thickness = flatFraction * diagonalOf(model);
  if (dimensionsOf(state.positions, thickness) >= dimensionsOf(model.restPositions, thickness)) {
    return false;
  }
  const Vec3 middle = std::accumulate(model.restPositions.begin(), model.restPositions.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(model.vertexCount());
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!model.pinned[v]) {
      state.positions[v] += addedFraction * (model.restPositions[v] - middle);
    }
  }
  return true;
}

}  // namespace drape::sim
