#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::sim::contact {

/// Number of floats in the widest vector in use. Arrays have that much padding at their end.
inline constexpr int maxLanes = 16;

/// Positions in float, one array per coordinate, padded so that whole vectors can be loaded and stored.
struct PositionLanes {
  std::vector<float> x, y, z;  ///< [m]

  void resize(std::size_t count) {
    for (std::vector<float>* part : {&x, &y, &z}) {
      part->resize(count + maxLanes);
    }
  }
};

/// An axis-aligned box [m]; initially empty (low > high).
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

// The functions below use the widest vector instructions of the machine.

/// The bounding box of the displacements of the first `count` positions from `since` to `positions`. Its diagonal
/// bounds the relative displacement of any two vertices.
LaneBox displacementsBetween(const PositionLanes& positions, const PositionLanes& since, int count);

/// Corners of triangles, one array each; ranges begin and end at multiples of `maxLanes`.
struct CornerLanes {
  std::vector<std::int32_t> a, b, c;
};

/// Whether the normal n of every triangle from begin to end - 1 is within a cone around a unit vector: n.axis > 0 and
/// (n.axis)^2 >= minSquaredCosine n.n.
bool normalsWithin(const PositionLanes& positions, const CornerLanes& corners, int begin, int end,
                   const std::array<float, 3>& axis, float minSquaredCosine);

/// Computes the normals of the first `count` triangles; their lengths are twice the areas [m^2].
void normalsOf(const PositionLanes& positions, const CornerLanes& corners, int count, PositionLanes& normals);

/// Whether a closed polygon in the plane is simple: no two sides touch that are not adjacent.
/// @param x, y its corners, then the first corner again and padding [m]
/// @param margin sides that come closer to each other than this may count as touching [m]
bool isSimplePolygon(const float* x, const float* y, int corners, float margin);

/// The response considers pairs up to this distance, over the thickness [-]: corrections of other pairs may move them
/// closer.
inline constexpr float closeMargin = 1.1F;

/// The bounding box of positions begin to end - 1.
LaneBox boxOf(const PositionLanes& positions, int begin, int end);

/// Appends to `inside` the indices of those of positions begin to end - 1 that lie in a box, ascending.
/// @param inside must have capacity for all of them and padding  @param count number of its entries
void positionsInside(const PositionLanes& positions, int begin, int end, const LaneBox& box, std::int32_t* inside,
                     int& count);

}  // namespace drape::sim::contact
