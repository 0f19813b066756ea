#pragma once

#include "session/snapshot.hpp"
#include "settings/settings.hpp"
#include "sim/stepper.hpp"

#include <string>
#include <utility>

namespace drape {

/// A second cloth of the same model that another solver moves. It has its own state and solver, so the first cloth does
/// not know of it.
class Ghost {
 public:
  /// Begins in `start`. Throws InputError when there is no solver of that name.
  Ghost(const std::string& solver, ClothState start) : stepper_(solver), state_(std::move(start)) {}

  /// Goes on from where it is with another solver.
  void useSolver(const std::string& name);

  /// Goes back to `start`.
  void reset(const ClothState& start);

  /// Moves what is pinned by `by` [m].
  void movePins(const ClothModel& model, const Vec3& by) { drape::movePins(model.pinned, by, state_); }

  /// Advances by one time step, in as many parts as `settings.ghost` says. False when the state stopped being finite.
  [[nodiscard]] bool step(const ClothModel& model, const Settings& settings, const StepInputs& inputs);

  [[nodiscard]] const SolverInfo& solver() const { return stepper_.info(); }
  [[nodiscard]] const ClothState& state() const { return state_; }

  /// Fills `status`, reusing its memory. `first` is the state of the first cloth.
  void capture(const ClothState& first, GhostStatus& status) const;

 private:
  Stepper stepper_;
  ClothState state_;
  StepReport report_;
  double stepSeconds_ = 0.0;  // what the last step cost
};

/// The parameters by which the ghost steps: the first cloth's, but for what `settings.ghost` says.
[[nodiscard]] StepParameters ghostParameters(const Settings& settings);

}  // namespace drape
