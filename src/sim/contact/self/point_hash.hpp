#pragma once

#include "sim/contact/self/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape {

/// Points that may meet: a place, the sub-surface and the vertex of each. Sub-surfaces ascend.
struct SurfacePoints {
  PositionLanes positions;
  std::vector<std::int32_t> patch;
  std::vector<std::int32_t> vertex;
  int count = 0;

  void resize(std::size_t capacity) {
    positions.resize(capacity);
    patch.resize(capacity + maxLanes);
    vertex.resize(capacity + maxLanes);
  }
};

/// A grid of cubic cells whose cells are hashed into n = 2^(bits of x + y + z) buckets. Cell (ix, iy, iz) goes into
///
///     (ix mod 2^bx) + 2^bx (iy mod 2^by) + 2^(bx + by) (iz mod 2^bz).
///
/// The bits go one by one to the axis along which most cells share an index so far, so that a cloth that fits into n
/// cells has a bucket for each; else two cells of one bucket lie 2^b cells apart.
struct HashGrid {
  std::array<float, 3> origin = {};  ///< a corner of cell (0, 0, 0) [m]
  float inverseSize = 1.0F;          ///< one over the side of a cell [1/m]
  std::array<int, 3> bits = {};      ///< bx, by, bz

  [[nodiscard]] int buckets() const { return 1 << (bits[0] + bits[1] + bits[2]); }
};

/// The grid for points in a box, with 2^totalBits buckets or as many as there are cells, if these are fewer.
[[nodiscard]] HashGrid hashGridOver(const LaneBox& box, const std::array<float, 3>& origin, float size, int totalBits);

/// The bucket of every point, by vector instructions.
void bucketsOf(const PositionLanes& positions, int count, const HashGrid& grid, std::int32_t* buckets);

/// Points sorted by their bucket, and within a bucket by sub-surface: run c of bucket b is bucket b of the set that
/// belongs to sub-surface c, so that all m sets take the room of one.
struct SortedPoints {
  SurfacePoints points;
  std::vector<std::int32_t> begin;   ///< where each bucket begins; one more than there are buckets
  std::vector<std::int32_t> bucket;  ///< of each point
  std::vector<std::int32_t> other;   ///< its bucket in the other grid, where pairs with equal ones are left out
};

/// Appends the pairs of points that share a bucket but no sub-surface and are nearer than the root of
/// `squaredReach` [m^2], in the order of the buckets; by vector instructions.
void pairsWithinBuckets(const SortedPoints& sorted, float squaredReach, bool skipSameOtherBucket,
                        std::vector<VertexPair>& pairs);

/// Finds near points by the paper's scheme (sec. 5.2): mass points are hashed by the cell that they lie in, twice, in
/// grids of different cell size, and tested against each other where they fall into the same bucket. Each
/// collision-free sub-surface has a set of buckets of its own, so that points of the same one never meet.
///
/// The cells of the first grid are `cellsPerReach` reaches wide, those of the second twice that and shifted by half a
/// cell of the first, so that no face of one grid lies nearer than half a cell to a parallel face of the other. Two
/// points nearer than the reach are then parted along any axis by one grid at most. They are missed when the first grid
/// parts them along one axis and the second along another; `missedShare` says how many that are.
///
/// Time and memory are linear in the number of points while the points of a bucket are bounded. Nothing is allocated
/// once the number of points no longer grows. The order of the pairs depends on nothing but the points.
class PointHash {
 public:
  static constexpr float cellsPerReach = 2.0F;

  /// The pairs of different sub-surfaces within `reach` [m] that share a bucket of either grid, each once.
  /// @param phase moves both grids, in cells of the second [-]
  void findPairs(const SurfacePoints& points, float reach, const std::array<float, 3>& phase,
                 std::vector<VertexPair>& pairs);

  /// True when findPairs has compared these two of its points, counted from 0.
  [[nodiscard]] bool compared(int a, int b) const {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    return first_[i] == first_[j] || second_[i] == second_[j];
  }

  /// Of pairs that far apart [m] in random directions, at random places of the grids, the share that is missed.
  [[nodiscard]] static double missedShare(double distance, double reach);

 private:
  void sort(const SurfacePoints& points, const std::vector<std::int32_t>& bucket, int buckets,
            const std::vector<std::int32_t>& other);

  std::vector<std::int32_t> first_, second_;  // bucket of each point in either grid
  SortedPoints sorted_;
  std::vector<std::int32_t> next_;
};

}  // namespace drape
