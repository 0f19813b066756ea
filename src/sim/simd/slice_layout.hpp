#pragma once

#include "sim/cloth_model.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape {

/// Vertices that are worked on together, one a lane, whatever the width of the machine's registers.
inline constexpr int sliceLanes = 16;

/// The springs of a cloth as a vector machine wants them: sliced ELLPACK. The vertices, in the order of a step, are cut
/// into slices of 16. Each slice has slots; a slot holds at most one spring of each of the slice's vertices. Where the
/// neighbours in a slot are consecutive (first + lane), they are loaded without a gather: near the speed of a stencil
/// on every mesh that is regular in places.
///
/// Every spring stands in it twice, once at either end, so that a vertex gathers all that acts on it and nobody writes
/// to anybody else's place: no colours, no atomics, and the result cannot depend on the number of threads.
struct SliceLayout {
  struct Slot {
    int first = 0;   ///< place of the neighbour of lane 0, when they are consecutive; may be negative
    int table = -1;  ///< else an index into neighbourTables
  };
  /// A triangle at each vertex of a slice, as two slots of that slice: its normal is offset(a) x offset(b).
  struct Corner {
    std::int32_t table = -1;  ///< an index into cornerTables; or
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
  std::vector<int> order;      ///< place -> vertex of the model
  bool ownOrder = false;       ///< the order is the model's own
  std::vector<int> place;      ///< vertex of the model -> place
  std::vector<int> slotBegin;  ///< slices + 1 entries
  std::vector<Slot> slots;
  /// For each slot its springs, -1 where a lane has none. Empty once a SlicedCloth has taken what it needs of them.
  std::vector<std::array<std::int32_t, sliceLanes>> springs;
  std::vector<NeighbourTable> neighbourTables;  ///< a lane without a spring points at itself
  std::vector<int> cornerBegin;                 ///< slices + 1 entries
  std::vector<Corner> corners;
  std::vector<CornerTable> cornerTables;
  std::vector<int> reach;  ///< for each slice the last slice that any of its springs leads to, itself included
  int mostSlots = 0;       ///< of a slice
  int longestReach = 0;    ///< largest reach[s] - s

  [[nodiscard]] int slices() const { return static_cast<int>(reach.size()); }
  /// So many slots have neighbours here and there that fetching them is what a step costs.
  [[nodiscard]] bool irregular() const { return neighbourTables.size() * 8 > slots.size(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// Throws InputError for a vertex with more springs than a 16-bit number counts.
[[nodiscard]] SliceLayout buildSliceLayout(const ClothModel& model);

}  // namespace drape
