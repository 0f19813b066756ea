#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/simd/slice_layout.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape::sim::simd {

/// The springs of a cloth as distance constraints for vector instructions: colour by colour, in batches of 16 springs
/// without a common vertex. Vertices are in permuted order (stepOrder), each with its inverse mass next to its
/// position, so that one instruction loads or stores an end.
///
/// Several threads may call the functions below at the same time, each on its part of the batches of one colour.
struct ConstraintLanes {
  explicit ConstraintLanes(const ClothModel& model);

  struct alignas(64) Batch {
    std::array<std::int32_t, sliceLanes> a{};  ///< permuted indices; lanes without a spring point to the dummy vertex
    std::array<std::int32_t, sliceLanes> b{};
    std::array<float, sliceLanes> restLength{};  ///< [m]
    std::array<float, sliceLanes> multiplier{};  ///< lambda [N s^2]
  };
  std::vector<int> order;         ///< permuted index -> vertex of the model
  std::vector<int> indexOf;       ///< vertex of the model -> permuted index
  Vec3 origin = Vec3::Zero();     ///< of the positions, see stepOrigin [m]
  std::vector<float> vertices;    ///< x y z [m] and inverse mass [1/kg] of each vertex, then a dummy without mass
  std::vector<float> predicted;   ///< positions under gravity and air alone in this step
  std::vector<float> velocities;  ///< x y z [m/s] and inverse mass [1/kg], likewise
  std::vector<Batch> batches;     ///< sorted by colour
  /// Relative stiffness of the springs of each batch [-]; empty if all springs are equally stiff.
  std::vector<std::array<float, sliceLanes>> relativeStiffness;
  std::vector<int> colourBegin;  ///< colours + 1 entries: batches

  [[nodiscard]] int colours() const { return static_cast<int>(colourBegin.size()) - 1; }
  [[nodiscard]] int vertexCount() const { return static_cast<int>(order.size()); }
};

/// A range of batches or of permuted indices: first and one past the last.
struct LaneRange {
  int begin = 0;
  int end = 0;

  /// The part of one of `members` threads.
  [[nodiscard]] LaneRange partOf(int member, int members) const;
};

void loadVertices(const ClothModel& model, const ClothState& state, ConstraintLanes& constraints, LaneRange range);

/// Writes positions and velocities. Pinned vertices keep their unrounded positions and get zero velocity.
void storeVertices(const ClothModel& model, const ConstraintLanes& constraints, ClothState& state, LaneRange range);

/// Starts a step: v' = v + h g and y = x + h v', except for pinned vertices.
/// @param gravity acceleration downwards (-y) [m/s^2]
void predictVertices(ConstraintLanes& constraints, float timeStep, float gravity, LaneRange range);

/// The same with gravity and air at `state`, which must equal the state in the lanes.
void predictWithAir(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                    ConstraintLanes& constraints, LaneRange range);

/// Ends a step whose positions are solved: v = v' + (x - y) / h, which equals (x - start) / h. In float positions are
/// too coarse for the difference x - start: with steps of 1/30000 s gravity would be lost.
void velocitiesFromVertices(ConstraintLanes& constraints, float timeStep, LaneRange range);

/// One iteration of XPBD over springs of one colour (Macklin, Mueller, Chentanez 2016, eqs. 17 and 18).
/// @param inverseCompliance h^2 k [kg] of a spring of relative stiffness 1  @param first whether the multipliers start
/// from zero
void projectSprings(ConstraintLanes& constraints, float inverseCompliance, bool first, LaneRange batches);

/// The dashpots of springs of one colour, each implicit for its two ends. @param strength h C_d [kg]
void dampSprings(ConstraintLanes& constraints, float strength, LaneRange batches);

}  // namespace drape::sim::simd
