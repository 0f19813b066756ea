#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/step_parameters.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape {

class BodyContact;
class SelfContact;

/// Whether there is a body that the cloth meets.
[[nodiscard]] bool meetsBodies(const StepParameters& parameters, const StepInputs& inputs);

/// Contact around a step of any solver (docs/theory/contact.md). The solver moves the cloth as if nothing were in its
/// way; then positions and velocities are corrected, so that the next step begins outside of everything and with no
/// velocity into it. It is done once a round of the step, not once a substep: a method that takes many small parts is
/// not made dearer by it, and what crosses a body within a step is found all the same.
///
/// Positions and velocities are corrected each by itself: what pushes the cloth out of something leaves no velocity
/// behind, and what is done to velocities only takes kinetic energy away, as seen from the body that is touched.
class ContactStage {
 public:
  ContactStage();
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;
  ContactStage(ContactStage&&) noexcept;
  ContactStage& operator=(ContactStage&&) noexcept;
  ~ContactStage();

  /// Keeps the state that the step begins with. Does nothing when no kind of contact is on.
  void begin(const StepParameters& parameters, const StepInputs& inputs, const ClothState& state);

  /// Whether the cloth is near a body, or on its way to one in this step, as far as its speed and gravity tell.
  /// To be asked only where there are bodies.
  [[nodiscard]] bool isNearBodies(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                  const ClothState& state);

  /// Whether the cloth may meet itself in this step: self-collision is on and knows of near pairs, or nothing yet.
  [[nodiscard]] static bool isNearItself(const StepParameters& parameters, const ClothState& state);

  /// Corrects the state that a solver has left. Does nothing when `begin` did nothing.
  /// @param shareOfStep that a round is of the user's step [-]: what is too near is pushed apart gently, once a step
  ContactReport resolve(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                        ClothState& state, double shareOfStep = 1.0);

  /// The state as the solver left it in the last step, or nullptr when contact was off or changed nothing.
  [[nodiscard]] const ClothState* unresolved() const { return changed_ ? &unresolved_ : nullptr; }

  /// Where the cloth touched something in the last step.
  [[nodiscard]] std::span<const ContactPoint> points() const { return points_; }

 private:
  BodyContact& bodyContact();

  bool active_ = false;
  bool changed_ = false;
  std::vector<Vec3> start_;              // positions when the step began [m]
  std::unique_ptr<BodyContact> bodies_;  // made when bodies are met
  ClothState unresolved_;
  std::vector<Vec3> ahead_;  // where the cloth's speed takes it [m]
  std::vector<ContactPoint> points_;
  std::unique_ptr<SelfContact> self_;  // made when it is asked for
};

}  // namespace drape
