#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/diagnostics.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// Where the energy of a cloth went: what damping, air, the hand and contact did to it over the steps that were added,
/// and what is left to explain, which is the method's own doing. Work of a force f over a step from x0 to x1 is taken
/// by the trapezoidal rule, (x1 - x0) . (f(0) + f(1)) / 2, whatever rule the method uses, so that two methods are held
/// to the same account. No work is done on a pinned vertex, unless a body carries it along: that is the body's.
///
/// The rule's own error falls with h^2, as does the integrator's part of a converged second-order method. Settings that
/// change between two steps (stiffness, gravity) are no error of the method: each step is judged under its own.
class EnergyBalance {
 public:
  /// Adds one step. `parameters` and `inputs` are those under which it was taken from `before` to `after`.
  /// @param unresolved the state that the method left before contact corrected it, or nullptr when nothing did
  /// @param earlierContact what contact had given or taken by then, where a step is taken in rounds [J]
  void add(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
           const ClothState& before, const ClothState& after, const ClothState* unresolved = nullptr,
           double earlierContact = 0.0);

  /// Change of kinetic + elastic + potential energy [J].
  [[nodiscard]] double change() const { return change_; }
  /// Work of the springs' damping [J]: negative where it takes energy.
  [[nodiscard]] double damping() const { return damping_; }
  /// Work of drag and lift [J]: of either sign in wind.
  [[nodiscard]] double air() const { return air_; }
  /// Work of the hand [J].
  [[nodiscard]] double attachment() const { return attachment_; }
  /// What contact gave or took [J]: bodies that move or carry pins, friction, impacts, pushing out of an overlap.
  [[nodiscard]] double contact() const { return contact_; }
  /// Change less these works [J]: positive where the method made energy from nothing, negative where it lost some.
  [[nodiscard]] double integrator() const { return change_ - damping_ - air_ - attachment_ - contact_; }

 private:
  double change_ = 0.0;
  double damping_ = 0.0;
  double air_ = 0.0;
  double attachment_ = 0.0;
  double contact_ = 0.0;
};

}  // namespace drape
