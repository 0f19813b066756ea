#include "sim/unfolding.hpp"

#include "sim/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drape {
namespace {

/// As a part of the rest shape's diagonal: thinner than this is flat.
constexpr double flatShare = 1e-9;
/// How much of the rest shape is added.
constexpr double nudge = 1e-6;

/// The point that lies farthest off, where `distance` says how far.
template <typename Distance>
Vec3 farthest(std::span<const Vec3> points, const Distance& distance) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
}

}  // namespace

int dimensionsOf(std::span<const Vec3> points, double thickness) {
  if (points.empty()) {
    return 0;
  }
  const Vec3 origin = points.front();
  const auto fromOrigin = [&](const Vec3& p) { return (p - origin).norm(); };
  const Vec3 end = farthest(points, fromOrigin);
  if (!(fromOrigin(end) > thickness)) {
    return 0;
  }
  const Vec3 along = (end - origin).normalized();
  const auto fromLine = [&](const Vec3& p) { return (p - origin - along.dot(p - origin) * along).norm(); };
  const Vec3 side = farthest(points, fromLine);
  if (!(fromLine(side) > thickness)) {
    return 1;
  }
  const Vec3 normal = along.cross(side - origin).normalized();
  const auto fromPlane = [&](const Vec3& p) { return std::abs(normal.dot(p - origin)); };
  return fromPlane(farthest(points, fromPlane)) > thickness ? 3 : 2;
}

bool makeUnfoldable(const ClothModel& model, ClothState& state) {
  const double thickness = flatShare * diagonalOf(model);
  if (dimensionsOf(state.positions, thickness) >= dimensionsOf(model.restPositions, thickness)) {
    return false;
  }
  const Vec3 middle = std::accumulate(model.restPositions.begin(), model.restPositions.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(model.vertexCount());
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!model.pinned[v]) {
      state.positions[v] += nudge * (model.restPositions[v] - middle);
    }
  }
  return true;
}

}  // namespace drape
