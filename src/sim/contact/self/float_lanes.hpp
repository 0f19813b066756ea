#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape {

/// Numbers in the widest vector that is used, and so the room that arrays have beyond their end.
inline constexpr int maxLanes = 16;

/// Places in float, one array a coordinate, with room at the end so that whole vectors can be loaded and stored.
struct PositionLanes {
  std::vector<float> x, y, z;  ///< [m]

  void resize(std::size_t count) {
    for (std::vector<float>* part : {&x, &y, &z}) {
      part->resize(count + maxLanes);
    }
  }
};

/// An axis-aligned box [m]; empty (low above high) until something is put in.
struct LaneBox {
  std::array<float, 3> low = {1e30F, 1e30F, 1e30F};
  std::array<float, 3> high = {-1e30F, -1e30F, -1e30F};

  [[nodiscard]] bool empty() const { return low[0] > high[0]; }
};

/// Two vertices, the lower index first.
struct VertexPair {
  int a = 0;
  int b = 0;
};

inline bool operator==(const VertexPair& x, const VertexPair& y) {
  return x.a == y.a && x.b == y.b;
}

inline bool operator<(const VertexPair& x, const VertexPair& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

// What follows runs by the widest vector instructions that the machine has.

/// How far the first `count` places are from where they were: all displacements lie in the box that is returned, so
/// that no two have moved against each other by more than its diagonal.
LaneBox displacementsBetween(const PositionLanes& positions, const PositionLanes& since, int count);

/// Corners of triangles, one array each; the ranges below begin and end at multiples of `mostLanes`.
struct CornerLanes {
  std::vector<std::int32_t> a, b, c;
};

/// True when every triangle of the range has its normal n within a cone around a unit vector: n.axis > 0 and
/// (n.axis)^2 >= leastSquaredCosine n.n.
bool normalsWithin(const PositionLanes& positions, const CornerLanes& corners, int begin, int end,
                   const std::array<float, 3>& axis, float minSquaredCosine);

/// The normals of all triangles, as long as twice their areas [m^2].
void normalsOf(const PositionLanes& positions, const CornerLanes& corners, int count, PositionLanes& normals);

/// True when no two sides of a closed polygon in the plane touch that are not next to each other.
/// @param x, y its corners and, after them, the first corner again and room for a vector
bool isSimplePolygon(const float* x, const float* y, int corners);

/// How much farther than the thickness a pair may be that a response looks at: what is done for others may move it.
inline constexpr float closeMargin = 1.1F;

/// The box around places begin to end - 1.
LaneBox boxOf(const PositionLanes& positions, int begin, int end);

/// Appends to `inside` the places begin to end - 1 that lie in a box, ascending.
/// @param inside must have room for all of them and a vector more  @param count how many it holds
void positionsInside(const PositionLanes& positions, int begin, int end, const LaneBox& box, std::int32_t* inside,
                     int& count);

}  // namespace drape
