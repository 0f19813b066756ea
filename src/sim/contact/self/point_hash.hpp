#pragma once

#include "sim/contact/self/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape::sim::contact {

/// Points that may collide: the position, the patch and the vertex of each, in ascending order of patches.
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

/// A grid of cubic cells that are hashed into n = 2^(bits of x + y + z) buckets. Cell (ix, iy, iz) maps to
///
///     (ix mod 2^bx) + 2^bx (iy mod 2^by) + 2^(bx + by) (iz mod 2^bz).
///
/// Each bit is assigned to the axis along which most cells share an index so far. So a cloth that fits into n cells has
/// a bucket for each; otherwise two cells of one bucket are 2^b cells apart.
struct HashGrid {
  std::array<float, 3> origin = {};  ///< a corner of cell (0, 0, 0) [m]
  float inverseSize = 1.0F;          ///< one over the side of a cell [1/m]
  std::array<int, 3> bits = {};      ///< bx, by, bz

  [[nodiscard]] int buckets() const { return 1 << (bits[0] + bits[1] + bits[2]); }
};

/// The grid for points in a box, with 2^totalBits buckets, or one per cell if that is fewer.
[[nodiscard]] HashGrid hashGridOver(const LaneBox& box, const std::array<float, 3>& origin, float size, int totalBits);

/// Computes the bucket of every point.
void bucketsOf(const PositionLanes& positions, int count, const HashGrid& grid, std::int32_t* buckets);

/// Points sorted by bucket, and within a bucket by patch. Run c of bucket b is bucket b of the hash table of patch c,
/// so that the tables of all patches share the memory of one.
struct SortedPoints {
  SurfacePoints points;
  std::vector<std::int32_t> begin;   ///< first point of each bucket, and one past the last
  std::vector<std::int32_t> bucket;  ///< of each point
  std::vector<std::int32_t> other;   ///< bucket of each point in the other grid, to skip pairs that share that one too
};

/// Appends the pairs of points in the same bucket, but of different patches, that are closer than the square root of
/// `squaredReach` [m^2], in the order of the buckets.
void pairsWithinBuckets(const SortedPoints& sorted, float squaredReach, bool skipSameOtherBucket,
                        std::vector<VertexPair>& pairs);

/// Finds near points by the method of the paper, sec. 5.2 (docs/theory/method.md): points are hashed by their cell in
/// two grids of different cell size, and points in the same bucket are tested against each other. Each collision-free
/// patch has its own buckets, so that points of the same patch are never tested.
///
/// Cells of the first grid are `cellsPerReach` times the reach wide. Those of the second are twice as wide and shifted
/// by half a cell of the first, so that parallel faces of the two grids are at least half a cell apart. So along any
/// axis at most one grid separates two points that are closer than the reach. A pair is missed if the first grid
/// separates it along one axis and the second along another; `missedFraction` returns the probability.
///
/// Time and memory are linear in the number of points if the number per bucket is bounded. Memory is allocated only
/// when the number of points grows. The order of the pairs depends only on the points.
class PointHash {
 public:
  static constexpr float cellsPerReach = 2.0F;

  /// Appends the pairs of different patches within `reach` [m] that share a bucket of either grid, each once.
  /// @param phase shift of both grids, in cells of the second [-]
  void findPairs(const SurfacePoints& points, float reach, const std::array<float, 3>& phase,
                 std::vector<VertexPair>& pairs);

  /// Whether the last findPairs tested these two points, by index.
  [[nodiscard]] bool compared(int a, int b) const {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    return first_[i] == first_[j] || second_[i] == second_[j];
  }

  /// The fraction of pairs at that distance [m] that is missed, for random directions and positions in the grids.
  [[nodiscard]] static double missedFraction(double distance, double reach);

 private:
  void sort(const SurfacePoints& points, const std::vector<std::int32_t>& bucket, int buckets,
            const std::vector<std::int32_t>& other);

  std::vector<std::int32_t> first_, second_;  // bucket of each point in either grid
  SortedPoints sorted_;
  std::vector<std::int32_t> next_;
};

}  // namespace drape::sim::contact
