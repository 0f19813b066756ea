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
/// Each vertex evaluates the triangles at its corners. Each triangle is evaluated three times, and no thread writes
/// another one's data. There are two forms.
///
/// In slices whose lanes all have the same corners, as on a grid, many slices share their numbers. There the triangles
/// of a side must give it the same rest length, which a pattern does not at its seams. A corner is a vertex i with the
/// neighbours j and k of two slots. The offsets to them are a and b. The force needs q of all three sides and the
/// tensions of two:
///
///     q_a = (|a|^2 - A^2) / 2,  q_b alike,  q_c = q_a + q_b + A.B - a.b  (the side from j to k)
///     t_a = K_aa q_a + K_ac q_c + K_ab q_b,  t_b = K_ab q_a + K_bc q_c + K_bb q_b,  force += t_a a + t_b b
///
/// A and B are a and b at rest.
///
/// In all other slices each triangle has its own numbers, so a form with few numbers is faster. The triangles of a
/// vertex are a fan: sectors between spokes. A spoke is the side to a neighbour. With the sides a and b of a sector,
///
///     f_1 = a_1 a + b_1 b,  f_2 = a_2 a + b_2 b  (the derivatives of x along warp and weft)
///     E_11 = (|f_1|^2 - 1) / 2,  E_22 alike,  2 E_12 = f_1.f_2,  sigma from the moduli and the stiffening
///     force += A ((a_1 + b_1) (s_11 f_1 + s_12 f_2) + (a_2 + b_2) (s_12 f_1 + s_22 f_2))
template <typename T>
struct SlicedFabric {
  /// The membrane at one corner of all lanes.
  struct Corner {
    SliceNumbers<T> aa{}, ac{}, ab{}, bc{}, bb{}, cc{};  ///< K [N/m^3]; 0 in lanes without the corner
    SliceNumbers<T> restDot{};                           ///< A.B [m^2]

    friend bool operator<(const Corner& one, const Corner& other) {
      return std::tie(one.aa, one.ac, one.ab, one.bc, one.bb, one.cc, one.restDot) <
             std::tie(other.aa, other.ac, other.ab, other.bc, other.bb, other.cc, other.restDot);
    }
  };
  /// The stiffening along warp or weft at one corner: with s = max(0, w_a q_a + w_c q_c + w_b q_b - start), t_a += s
  /// w_a and t_b += s w_b. The energy of the triangle is s^2 / 2.
  struct Stiffening {
    SliceNumbers<T> a{}, c{}, b{}, start{};

    friend bool operator<(const Stiffening& one, const Stiffening& other) {
      return std::tie(one.a, one.c, one.b, one.start) < std::tie(other.a, other.c, other.b, other.start);
    }
  };
  /// One sector of the fans of a slice; 0 in lanes without a triangle there.
  struct Sector {
    SliceNumbers<T> a1{}, a2{}, b1{}, b2{};  ///< the inverse of the sides at rest [1/m]
    SliceNumbers<T> area{};  ///< of the triangle at rest times its clamping [m^2]; negative if its order is b, a
  };
  /// The moduli of the lanes of a slice. All triangles of a vertex have the same.
  struct Moduli {
    SliceNumbers<T> warp{}, weft{}, across{}, shear{};   ///< C_11, C_22, C_12, C_33 [N/m]
    SliceNumbers<T> stiffeningStrain{};                  ///< [-]
    SliceNumbers<T> stiffeningWarp{}, stiffeningWeft{};  ///< [N/m]
    bool stiffens = false;                               ///< some of the lanes
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

  /// The moments of a fabric that is bent at rest. Each vertex adds nu (x_b - x_a) x (x_c - x_a) for each of its
  /// hinges.
  struct RestMoment {
    std::array<SliceLayout::NeighbourTable, 3> others{};  ///< a, b, c; the lane's own vertex where there is none
    SliceNumbers<T> modulus{};                            ///< nu [N/m^2]; 0 likewise
  };

  std::vector<std::uint8_t> hasCommonCorners;  ///< of each slice: whether it has the first form
  std::vector<int> cornerOf;                   ///< of each SliceLayout::Corner: index into `corners`
  std::vector<Corner> corners;                 ///< shared by the regular parts of a mesh
  /// Along warp and weft, in the order of `corners`; empty if the fabric does not stiffen.
  std::vector<std::array<Stiffening, 2>> stiffening;
  std::vector<Moduli> moduli;  ///< one if the cloth has one material, else one a slice
  /// The damping of stretch of each lane over the largest one of the cloth [-]; empty if all are 1.
  std::vector<SliceNumbers<T>> relativeDamping;
  std::vector<int> spokeBegin;            ///< slices + 1 entries
  std::vector<SliceLayout::Slot> spokes;  ///< a lane without one has its own vertex
  std::vector<SliceLayout::NeighbourTable> spokeTables;
  std::vector<Sector> sectors;     ///< between each spoke and the one before it; 0 at the first spoke of a part
  std::optional<Bending> bending;  ///< nothing if the fabric does not resist bending

  std::vector<int> momentBegin;  ///< slices + 1 entries; empty if the fabric is flat at rest
  std::vector<RestMoment> moments;

  [[nodiscard]] const Moduli& moduliOf(int slice) const { return moduli[moduli.size() == 1 ? 0 : slice]; }

  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// Builds it for a model with a fabric, and extends the layout's bandwidth to the neighbours of bending.
template <typename T>
[[nodiscard]] SlicedFabric<T> buildSlicedFabric(const ClothModel& model, SliceLayout& layout);

}  // namespace drape::sim::simd
