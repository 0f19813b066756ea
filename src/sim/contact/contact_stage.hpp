#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/contact/self_approach.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

class BodyContact;
class ExactSelfContact;
struct ExactStep;
class SelfContact;

/// Whether body contact is on and the scene has bodies.
[[nodiscard]] bool meetsBodies(const ContactParameters& contact, const StepInputs& inputs);

/// Contact for a step of any solver (docs/theory/contact.md). The solver predicts the motion without contact. Then
/// contact corrects positions and velocities, so that the next step starts without overlap and without approach
/// velocity. It runs once per contact substep, not once per solver substep: many solver substeps do not make it more
/// expensive, and motion through a body within a step is still found.
///
/// Positions and velocities are corrected separately. Position corrections leave no velocity behind. Velocity
/// corrections only remove kinetic energy, in the frame of the body in contact.
class ContactStage {
 public:
  ContactStage();
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;
  ContactStage(ContactStage&&) noexcept;
  ContactStage& operator=(ContactStage&&) noexcept;
  ~ContactStage();

  /// Stores the state at the start of the step. Does nothing if contact is off.
  void begin(const ContactParameters& contact, const StepInputs& inputs, const ClothState& state);

  /// Whether the cloth is near a body or, by its velocity and gravity, comes near one in this step.
  /// Requires bodies.
  [[nodiscard]] bool isNearBodies(const ClothModel& model, const CommonParameters& parameters,
                                  const ContactParameters& contact, const StepInputs& inputs, const ClothState& state);

  /// Whether the cloth may collide with itself in this step, and how fast. With the hash: there are near pairs, or no
  /// search was made yet. With exact self-collision: features come into contact if the velocities do not change.
  [[nodiscard]] SelfApproach approachOfItself(const ClothModel& model, const CommonParameters& parameters,
                                              const ContactParameters& contact, const ClothState& state);

  /// Finds the contacts, with bodies and of the cloth with itself, that a solver can resolve in its substeps, for a
  /// step from `state`. Stores the list of near pairs of the cloth in it.
  void findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                           const ContactParameters& contact, const StepInputs& inputs, ClothState& state,
                           std::vector<SubstepContact>& found);

  /// Adds the contacts of the cloth with itself that the predicted state violates and that `findSubstepContacts` did
  /// not list. Only with exact self-collision.
  /// @returns whether there are any
  bool addMissedContacts(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                         const ClothState& state, std::vector<SubstepContact>& listed);

  /// Corrects the predicted state. Does nothing if `begin` did nothing.
  /// @param stepFraction length of this contact substep over that of the user's step [-]; scales how far pairs that are
  /// too close are pushed apart
  ContactReport resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                        const StepInputs& inputs, ClothState& state, double stepFraction = 1.0);

  /// Replaces `resolve` in a step of sleeping cloth, which needs no contact: its contacts are those of the last
  /// `resolve`.
  /// @returns the report of that, without times
  ContactReport keepLast();

  /// The predicted state of the last step; nullptr if contact was off or changed nothing.
  [[nodiscard]] const ClothState* unresolved() const { return changed_ ? &unresolved_ : nullptr; }

  /// The active contacts of the last `resolve`.
  [[nodiscard]] std::span<const ContactPoint> points() const { return points_; }

 private:
  /// Extrapolates the positions by the velocities over a time step, into `ahead_`.
  void extrapolate(const ClothState& state, double timeStep);
  BodyContact& bodyContact();
  SelfContact& selfContact();
  ExactSelfContact& exactSelfContact();
  ContactReport correct(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                        const StepInputs& inputs, ClothState& state, double stepFraction);
  void guardAgainstItself(const ExactStep& step, const std::vector<BodyStep>* bodies, ClothState& state,
                          ContactReport& report);

  bool active_ = false;
  bool changed_ = false;
  std::vector<Vec3> start_;              // positions at the start of the step [m]
  std::unique_ptr<BodyContact> bodies_;  // created at first use
  ClothState unresolved_;
  ClothState beforeGuard_;
  std::vector<Vec3> ahead_;  // positions extrapolated by the velocity [m]
  std::vector<ContactPoint> points_;
  ContactReport report_;                     // of the last `resolve`
  double bodySeconds_ = 0.0;                 // of findSubstepContacts [s]
  double selfSeconds_ = 0.0;                 // likewise
  std::unique_ptr<SelfContact> self_;        // created at first use
  std::unique_ptr<ExactSelfContact> exact_;  // likewise
  std::vector<SeparatingPlane> planes_;      // of bodies, for the guard
  std::vector<Vec3> unguarded_;              // positions before the guard [m]
  std::vector<Vec3> resolved_;               // positions after contact with bodies, before the guard [m]
  std::vector<Vec3> fallback_;               // positions at the start, carried along by the bodies [m]
};

}  // namespace drape::sim::contact
