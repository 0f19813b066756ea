#pragma once

#include "sim/model/cloth_model.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape::sim::simd {

/// Number of vertices in a slice, one for each lane, independent of the register width.
inline constexpr int sliceLanes = 16;

/// The springs of a cloth in a layout for vector instructions: sliced ELLPACK. The vertices are permuted (stepOrder)
/// and cut into slices of 16. Each slice has slots; a slot holds at most one spring of each vertex of the slice. If the
/// neighbours in a slot are consecutive (first + lane), they are loaded without a gather. Regular parts of a mesh then
/// run almost at the speed of a stencil.
///
/// Every spring is stored twice, once at each end. Each vertex gathers all forces on it and writes only its own data.
/// So no colouring or atomics are needed, and the result does not depend on the number of threads.
struct SliceLayout {
  struct Slot {
    int first = 0;   ///< permuted index of the neighbour of lane 0, if consecutive; may be negative
    int table = -1;  ///< otherwise an index into neighbourTables
  };
  /// One triangle at each vertex of a slice, as two slots of that slice: its normal is offset(a) x offset(b).
  struct Corner {
    std::int32_t table = -1;  ///< an index into cornerTables; -1: slotA and slotB hold
    std::uint16_t slotA = 0;  ///< the same for all lanes
    std::uint16_t slotB = 0;
    std::uint16_t lanes = 0;  ///< a bit for each lane that has it
  };
  using NeighbourTable = std::array<std::int32_t, sliceLanes>;
  struct CornerTable {
    std::array<std::uint16_t, sliceLanes> a{};  ///< slots; 0 where absent
    std::array<std::uint16_t, sliceLanes> b{};
  };

  int vertices = 0;
  std::vector<int> order;      ///< permuted index -> vertex of the model
  bool isModelOrder = false;   ///< the permutation is the identity
  std::vector<int> indexOf;    ///< vertex of the model -> permuted index
  std::vector<int> slotBegin;  ///< slices + 1 entries
  std::vector<Slot> slots;
  /// The springs of each slot, -1 in lanes without one. SlicedCloth clears it after use.
  std::vector<std::array<std::int32_t, sliceLanes>> springs;
  std::vector<NeighbourTable> neighbourTables;  ///< a lane without a spring points at itself
  std::vector<int> cornerBegin;                 ///< slices + 1 entries
  std::vector<Corner> corners;
  std::vector<CornerTable> cornerTables;
  /// A triangle of the model at one lane of a corner.
  struct CornerUse {
    std::size_t corner = 0;  ///< index into `corners`
    std::size_t lane = 0;
    std::size_t triangle = 0;          ///< of the model
    std::size_t cornerOfTriangle = 0;  ///< the triangle's corner at the vertex, 0 to 2
  };
  std::vector<CornerUse> cornerUses;    ///< empty without a fabric; SlicedCloth clears it after use
  std::vector<int> lastNeighbourSlice;  ///< of each slice, not decreasing and never before the slice itself
  int maxSlots = 0;                     ///< largest number of slots of a slice
  int sliceBandwidth = 0;               ///< largest lastNeighbourSlice[s] - s

  [[nodiscard]] int slices() const { return static_cast<int>(lastNeighbourSlice.size()); }
  /// True if so many slots need gathers that they dominate the cost of a step.
  [[nodiscard]] bool irregular() const { return neighbourTables.size() * 8 > slots.size(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// Throws ClothModelError for a vertex with more springs than a 16-bit number counts.
[[nodiscard]] SliceLayout buildSliceLayout(const ClothModel& model);

/// Computes what follows from `lastNeighbourSlice`, and makes it non-decreasing.
void finishBandwidth(SliceLayout& layout);

}  // namespace drape::sim::simd
