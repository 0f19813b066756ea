#pragma once

#include "session/pin_places.hpp"
#include "session/snapshot.hpp"
#include "settings/settings.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/stepping/sewn_cloth.hpp"
#include "sim/stepping/stepper.hpp"

#include <string>
#include <utility>
#include <vector>

namespace drape::session {

/// A second cloth of the same model, moved by another solver. It has its own state and solver and does not affect the
/// first cloth.
class Ghost {
 public:
  /// Starts from `start`. Throws InputError when no solver has that name.
  Ghost(const std::string& solver, sim::ClothState start) : stepper_(solver), state_(std::move(start)) {}

  /// Continues from the current state with another solver.
  void useSolver(const std::string& name);

  /// Returns to `start`.
  void reset(const sim::ClothState& start);

  /// Moves the pinned vertices by `by` [m].
  void movePins(const sim::ClothModel& model, const Vec3& by) {
    sim::movePins(sim::fabric::ownPinsOf(model), by, state_);
  }

  /// Moves vertices to places [m], at rest.
  void placePins(const std::vector<int>& vertices, const std::vector<Vec3>& places) {
    placeVertices(vertices, places, state_);
  }

  /// Advances by one time step, with the substeps of `settings.ghost`. False when the state is no longer finite.
  /// @param cloth the first one; other seams can be welded in it than in the ghost
  [[nodiscard]] bool step(const sim::SewnCloth& cloth, const settings::Settings& settings,
                          const sim::StepInputs& inputs);

  [[nodiscard]] const sim::SolverInfo& solver() const { return stepper_.info(); }
  [[nodiscard]] const sim::ClothState& state() const { return state_; }

  /// Fills `status`, reusing its memory. `first` is the state of the first cloth.
  void capture(const sim::ClothState& first, GhostStatus& status) const;

 private:
  void useCloth(const sim::SewnCloth& first);

  sim::Stepper stepper_;
  sim::SewnCloth cloth_;
  sim::ClothState state_;
  sim::StepReport report_;
  double stepSeconds_ = 0.0;  // duration of the last step
};

/// The step parameters of the ghost: those of the first cloth, with the values of `settings.ghost`.
[[nodiscard]] sim::StepParameters ghostParameters(const settings::Settings& settings);

}  // namespace drape::session
