#include "sim/contact/self/point_hash.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::contact {
namespace {

/// The smallest number of bits that distinguishes so many values.
int bitsFor(int values) {
  int bits = 0;
  while ((1 << bits) < values) {
    ++bits;
  }
  return bits;
}

/// Upper bound of the number of cells that a box spans along an axis [-].
int cellsAlong(const LaneBox& box, std::size_t axis, float size) {
  constexpr float maximum = 1e6F;
  return static_cast<int>(std::min(maximum, (box.high[axis] - box.low[axis]) / size)) + 2;
}

}  // namespace

HashGrid hashGridOver(const LaneBox& box, const std::array<float, 3>& origin, float size, int totalBits) {
  HashGrid grid;
  grid.origin = origin;
  grid.inverseSize = 1.0F / size;
  std::array<int, 3> left{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    left[axis] = bitsFor(cellsAlong(box, axis, size));
  }
  for (int bit = 0; bit < totalBits; ++bit) {
    const auto axis = static_cast<std::size_t>(std::max_element(left.begin(), left.end()) - left.begin());
    if (left[axis] == 0) {
      break;
    }
    --left[axis];
    ++grid.bits[axis];
  }
  return grid;
}

void PointHash::sort(const SurfacePoints& points, const std::vector<std::int32_t>& bucket, int buckets,
                     const std::vector<std::int32_t>& other) {
  const auto count = static_cast<std::size_t>(points.count);
  sorted_.begin.assign(static_cast<std::size_t>(buckets) + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    ++sorted_.begin[bucket[i]];
  }
  std::int32_t sum = 0;
  for (std::int32_t& begin : sorted_.begin) {
    const std::int32_t here = begin;
    begin = sum;
    sum += here;
  }
  next_.assign(sorted_.begin.begin(), sorted_.begin.end());
  sorted_.points.count = points.count;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(next_[bucket[i]]++);
    sorted_.points.positions.x[at] = points.positions.x[i];
    sorted_.points.positions.y[at] = points.positions.y[i];
    sorted_.points.positions.z[at] = points.positions.z[i];
    sorted_.points.patch[at] = points.patch[i];
    sorted_.points.vertex[at] = points.vertex[i];
    sorted_.bucket[at] = bucket[i];
    sorted_.other[at] = other[i];
  }
}

void PointHash::findPairs(const SurfacePoints& points, float reach, const std::array<float, 3>& phase,
                          std::vector<VertexPair>& pairs) {
  const auto capacity = static_cast<std::size_t>(points.count) + maxLanes;
  if (first_.size() < capacity) {
    first_.resize(capacity);
    second_.resize(capacity);
    sorted_.points.resize(capacity);
    sorted_.bucket.resize(capacity);
    sorted_.other.resize(capacity);
  }
  const LaneBox box = boxOf(points.positions, 0, points.count);
  const float size = cellsPerReach * reach;
  std::array<float, 3> origin{};
  std::array<float, 3> shifted{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin[axis] = box.low[axis] - 2.0F * size * phase[axis];
    shifted[axis] = origin[axis] - 0.5F * size;
  }
  const int totalBits = bitsFor(points.count);
  const HashGrid fine = hashGridOver(box, origin, size, totalBits);
  const HashGrid coarse = hashGridOver(box, shifted, 2.0F * size, totalBits);
  bucketsOf(points.positions, points.count, fine, first_.data());
  bucketsOf(points.positions, points.count, coarse, second_.data());
  sort(points, first_, fine.buckets(), second_);
  pairsWithinBuckets(sorted_, reach * reach, false, pairs);
  sort(points, second_, coarse.buckets(), first_);
  pairsWithinBuckets(sorted_, reach * reach, true, pairs);
}

double PointHash::missedFraction(double distance, double reach) {
  // Along an axis, a face of the first grid separates a pair with probability |d| / size, one of the second grid with
  // half of that, never both. The pair is missed if each grid separates it along some axis. Mean over all directions:
  constexpr int steps = 64;
  const double unit = distance / (static_cast<double>(cellsPerReach) * reach);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double z = (i + 0.5) / steps;
      const double angle = 0.5 * std::numbers::pi * (j + 0.5) / steps;
      const double flat = std::sqrt(1.0 - z * z);
      double noFirst = 1.0;
      double noSecond = 1.0;
      double none = 1.0;
      for (const double part : {flat * std::cos(angle), flat * std::sin(angle), z}) {
        noFirst *= 1.0 - unit * part;
        noSecond *= 1.0 - 0.5 * unit * part;
        none *= 1.0 - 1.5 * unit * part;
      }
      sum += 1.0 - noFirst - noSecond + none;
    }
  }
  return sum / (steps * steps);
}

}  // namespace drape::sim::contact
