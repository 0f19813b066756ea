#pragma once

#include "sim/simd/slice_layout.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace drape::sim::simd {

/// Numbers for the lanes of a slice, aligned to a cache line so that no load straddles two.
template <typename T>
struct alignas(64) SliceNumbers : std::array<T, sliceLanes> {};

/// The fabric of a cloth in the sliced layout (sim/fabric/fabric.hpp has the formulas).
///
/// Each vertex evaluates the triangles at its corners: the vertex i with the ends j and k of two of its slots, whose
/// offsets are a and b. Its forces need q of all three sides and the tensions of two:
///
///     q_a = (|a|^2 - A^2) / 2,  q_b alike,  q_c = q_a + q_b + A.B - a.b  (the side from j to k)
///     t_a = K_aa q_a + K_ac q_c + K_ab q_b,  t_b = K_ab q_a + K_bc q_c + K_bb q_b,  force += t_a a + t_b b
///
/// A and B are a and b at rest. Each triangle is
/// evaluated three times, and no thread writes another one's data.
template <typename T>
struct SlicedFabric {
  /// The membrane at one corner.
  struct Corner {
    SliceNumbers<T> aa, ac, ab, bc, bb;  ///< K [N/m^3]; 0 in lanes without the corner
    SliceNumbers<T> restDot;             ///< A.B [m^2]

    friend bool operator<(const Corner& one, const Corner& other) {
      return std::tie(one.aa, one.ac, one.ab, one.bc, one.bb, one.restDot) <
             std::tie(other.aa, other.ac, other.ab, other.bc, other.bb, other.restDot);
    }
  };
  /// The stiffening along warp or weft at one corner: with s = max(0, w_a q_a + w_c q_c + w_b q_b - start), t_a += s
  /// w_a and t_b += s w_b. The energy of the triangle is s^2 / 2.
  struct Stiffening {
    SliceNumbers<T> a, c, b, start;
  };
  /// Bending: slots of neighbours with an entry of the matrix each, as the slots of springs.
  struct Bending {
    std::vector<int> slotBegin;  ///< slices + 1 entries
    std::vector<SliceLayout::Slot> slots;
    std::vector<SliceLayout::NeighbourTable> tables;
    std::vector<int> entriesOf;  ///< of each slot: index into `entries`
    /// Minus the entry of the matrix [N/m]; 0 in lanes without a neighbour. Regular parts of a mesh share them, so that
    /// they stay in the cache.
    std::vector<SliceNumbers<T>> entries;
  };

  std::vector<std::uint8_t> hasCommonCorners;         ///< of each slice: whether all of its lanes have the same corners
  std::vector<int> cornerOf;                          ///< of each SliceLayout::Corner: index into `corners`
  std::vector<Corner> corners;                        ///< shared by the regular parts of a mesh
  std::vector<std::array<Stiffening, 2>> stiffening;  ///< along warp and weft; empty if the fabric does not stiffen
  std::optional<Bending> bending;                     ///< nothing if the fabric does not resist bending

  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// Builds it for a model with a fabric, and extends the layout's bandwidth to the neighbours of bending.
template <typename T>
[[nodiscard]] SlicedFabric<T> buildSlicedFabric(const ClothModel& model, SliceLayout& layout);

}  // namespace drape::sim::simd
