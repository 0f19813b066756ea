#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/simd/slice_layout.hpp"
#include "sim/step_parameters.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace drape {

/// The springs of a cloth as distance constraints for vector instructions: colour by colour, 16 springs a batch, none
/// of which share a vertex. Vertices stand in the order of a step, each with its inverse mass beside its place, so that
/// an end is fetched and put back by one instruction each.
///
/// What a function below does to the batches of one colour, several threads may do to a part of them each.
struct ConstraintLanes {
  explicit ConstraintLanes(const ClothModel& model);

  struct alignas(64) Batch {
    std::array<std::int32_t, sliceLanes> a{};  ///< places; lanes without a spring have both ends at a place of no mass
    std::array<std::int32_t, sliceLanes> b{};
    std::array<float, sliceLanes> restLength{};  ///< [m]
    std::array<float, sliceLanes> multiplier{};  ///< lambda [N s^2]
  };
  std::vector<int> order;         ///< place -> vertex of the model
  std::vector<int> place;         ///< vertex of the model -> place
  std::vector<float> vertices;    ///< x y z [m] and inverse mass [1/kg] for each place, then the place of no mass
  std::vector<float> predicted;   ///< where gravity and air alone would have led them in this step
  std::vector<float> velocities;  ///< x y z [m/s] and inverse mass [1/kg], likewise
  std::vector<Batch> batches;     ///< of one colour after the other
  /// One a batch: how stiff its springs are [-]; empty when all are equally stiff.
  std::vector<std::array<float, sliceLanes>> relativeStiffness;
  std::vector<int> colourBegin;  ///< colours + 1 entries: batches

  [[nodiscard]] int colours() const { return static_cast<int>(colourBegin.size()) - 1; }
  [[nodiscard]] int places() const { return static_cast<int>(order.size()); }
};

/// Some of the batches or of the places, first and one past the last.
struct LaneRange {
  int begin = 0;
  int end = 0;

  /// The part of one of `members` threads.
  [[nodiscard]] LaneRange partOf(int member, int members) const;
};

void loadPlaces(const ClothModel& model, const ClothState& state, ConstraintLanes& constraints, LaneRange places);

/// Pinned vertices stay in the state where they were, unrounded, and get no velocity.
void storePlaces(const ClothModel& model, const ConstraintLanes& constraints, ClothState& state, LaneRange places);

/// Starts a step: v' = v + h g and y = x + h v', pinned vertices excepted.
/// @param gravity acceleration downwards (-y) [m/s^2]
void predictPlaces(ConstraintLanes& constraints, float timeStep, float gravity, LaneRange places);

/// The same with gravity and air at `state`, which must be what the lanes hold.
void predictPlacesInAir(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                        ConstraintLanes& constraints, LaneRange places);

/// Ends a step whose places are known: v = v' + (x - y) / h, which is the step's (x - start) / h. Places in float are
/// too coarse for that difference: with steps of 1/30000 s gravity would be lost.
void velocitiesFromPlaces(ConstraintLanes& constraints, float timeStep, LaneRange places);

/// One iteration of XPBD over springs of one colour (Macklin, Mueller, Chentanez 2016, eqs. 17 and 18).
/// @param inverseCompliance h^2 k [kg] of a spring of relative stiffness 1  @param first the multipliers start from
/// zero
void projectSprings(ConstraintLanes& constraints, float inverseCompliance, bool first, LaneRange batches);

/// The dashpots of springs of one colour, each implicit for its two ends alone. @param strength h C_d [kg]
void dampSprings(ConstraintLanes& constraints, float strength, LaneRange batches);

}  // namespace drape
