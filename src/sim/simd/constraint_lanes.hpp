#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/simd/slice_layout.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape {

/// The springs of a cloth as distance constraints for vector instructions: colour by colour, 16 springs a batch, none
/// of which share a vertex. Vertices stand in the order of a step, each with its inverse mass beside its place, so that
/// an end is fetched and put back by one instruction each.
struct ConstraintLanes {
  explicit ConstraintLanes(const ClothModel& model);

  void load(const ClothModel& model, const std::vector<Vec3>& positions);
  void store(std::vector<Vec3>& positions) const;

  struct alignas(64) Batch {
    std::array<std::int32_t, sliceLanes> a{};  ///< places; lanes without a spring have both ends at a place of no mass
    std::array<std::int32_t, sliceLanes> b{};
    std::array<float, sliceLanes> restLength{};  ///< [m]
    std::array<float, sliceLanes> multiplier{};  ///< lambda [N s^2]
  };
  std::vector<int> order;       ///< place -> vertex of the model
  std::vector<float> vertices;  ///< x y z [m] and inverse mass [1/kg] for each place, then the place of no mass
  std::vector<Batch> batches;   ///< of one colour after the other
};

/// One iteration of XPBD over all springs (Macklin, Mueller, Chentanez 2016, eqs. 17 and 18).
/// @param inverseCompliance h^2 k [kg]
void projectSprings(ConstraintLanes& constraints, float inverseCompliance);

}  // namespace drape
