#pragma once

#include "sim/forces/diagnostics.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"

namespace drape::sim {

/// Energy changes that do not follow from the state before and after a step [J].
struct WorkApart {
  double earlierContact = 0.0;  ///< by contact in the contact substeps before the last one
  double damping = 0.0;         ///< by the damping of a fabric and by settling
  double unsteadyAir = 0.0;     ///< by the unsteady forces of the air (UnsteadyAir)
};

/// The energy balance of a cloth over the added steps: the work of damping, air, attachment and contact, and the
/// remainder, which is the error of the integrator. The work of a force f over a step from x0 to x1 is computed by the
/// trapezoidal rule, (x1 - x0) . (f(0) + f(1)) / 2, for every method, so that methods are comparable. Pinned vertices
/// do no work, unless a body moves them; that counts as contact.
///
/// The error of the rule falls with h^2, as does the integrator's part of a converged second-order method. Settings
/// that change between two steps (stiffness, gravity) cause no error: each step is evaluated with its own settings.
class EnergyBalance {
 public:
  /// Adds one step from `before` to `after`, with its `parameters` and `inputs`.
  /// @param unresolved the state before contact corrected it, or nullptr if it did not
  /// @param apart what the stepper measured itself
  void add(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
           const ClothState& before, const ClothState& after, const ClothState* unresolved = nullptr,
           const WorkApart& apart = {});

  /// Change of kinetic + elastic + potential energy [J].
  [[nodiscard]] double change() const { return change_; }
  /// Work of the damping of springs or of a fabric [J]; negative if it removes energy.
  [[nodiscard]] double damping() const { return damping_; }
  /// Work of the air [J]; of either sign in wind.
  [[nodiscard]] double air() const { return air_; }
  /// Work of the attachment [J].
  [[nodiscard]] double attachment() const { return attachment_; }
  /// Energy change by contact [J]: moving bodies and their pins, friction, impacts, resolved overlaps.
  [[nodiscard]] double contact() const { return contact_; }
  /// Energy change minus all of these [J]: positive if the method gained energy, negative if it lost energy.
  [[nodiscard]] double integrator() const { return change_ - damping_ - air_ - attachment_ - contact_; }

 private:
  double change_ = 0.0;
  double damping_ = 0.0;
  double air_ = 0.0;
  double attachment_ = 0.0;
  double contact_ = 0.0;
};

}  // namespace drape::sim
