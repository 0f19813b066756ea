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

/// Contact for the steps of any solver (docs/theory/contact.md). The solver predicts the motion without contact. Then
/// contact corrects positions and velocities, so that the next step starts without overlap and without approach
/// velocity. A contact substep has these stages:
///
/// 1. `begin` stores the positions at its start.
/// 2. With a solver that resolves contacts, `findSubstepContacts` lists the contacts for its substeps.
/// 3. The solver moves the cloth: predicted positions and velocities.
/// 4. `resolve` corrects them: by self-collision (SelfContact or ExactSelfContact), then by contact with bodies
///    (BodyContact), then by the guard against intersections of the cloth with itself (ExactSelfContact::guard).
///
/// Contact acts once per contact substep, not once per solver substep. So its cost does not grow with the number of
/// solver substeps. It still detects motion through a body within a contact substep. The parameters of all functions
/// are those of the contact substep: CommonParameters::timeStep is its length [s], and StepInputs::bodies has the
/// motion of the bodies in it.
///
/// Positions and velocities are corrected separately. A correction of positions adds no velocity, except in
/// self-collision by the hash (SelfResponse). Velocity corrections only remove kinetic energy, in the frame of the body
/// in contact.
class ContactStage {
 public:
  ContactStage();
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;
  ContactStage(ContactStage&&) noexcept;
  ContactStage& operator=(ContactStage&&) noexcept;
  ~ContactStage();

  /// Stores the positions at the start of a contact substep. Does nothing if contact is off.
  void begin(const ContactParameters& contact, const StepInputs& inputs, const ClothState& state);

  /// Whether the cloth is near a body or, by its velocity and gravity, comes near one in this step. Requires bodies
  /// (meetsBodies).
  [[nodiscard]] bool isNearBodies(const ClothModel& model, const CommonParameters& parameters,
                                  const ContactParameters& contact, const StepInputs& inputs, const ClothState& state);

  /// Whether the cloth may collide with itself in this step, and how fast. With the hash: there are near pairs, or no
  /// search was made yet. With exact self-collision: features come into contact if the velocities do not change.
  [[nodiscard]] SelfApproach approachOfItself(const ClothModel& model, const CommonParameters& parameters,
                                              const ContactParameters& contact, const ClothState& state);

  /// Finds the contacts, with bodies and of the cloth with itself, that a solver can resolve in its substeps, for a
  /// contact substep from `state`. With the hash, stores the list of near pairs of the cloth in `state`.
  /// @param found the contacts are appended
  void findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                           const ContactParameters& contact, const StepInputs& inputs, ClothState& state,
                           std::vector<SubstepContact>& found);

  /// Adds the contacts of the cloth with itself that the predicted state violates and that `findSubstepContacts` did
  /// not list. Only with exact self-collision.
  /// @param listed the contacts are appended  @returns whether there are any
  bool addMissedContacts(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                         const ClothState& state, std::vector<SubstepContact>& listed);

  /// Corrects the positions and velocities of the predicted state. Does nothing if `begin` did nothing.
  /// @param stepFraction length of this contact substep over that of the user's step [-]; scales how far pairs that are
  /// too close are pushed apart
  ContactReport resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                        const StepInputs& inputs, ClothState& state, double stepFraction = 1.0);

  /// Replaces `resolve` in a step of sleeping cloth, which needs no contact: its contacts are those of the last
  /// `resolve`.
  /// @returns the report of the last `resolve`, without times and work
  ContactReport keepLast();

  /// The predicted positions and velocities of the last `resolve`; nullptr if contact was off or had no contacts.
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
  int guardOnce(const ExactStep& step, bool isFirst, ClothState& state);
  void setPlanesAfter(std::ptrdiff_t kept);
  void setFallback(const ClothState& state);
  void guardAgainstItself(const ExactStep& step, const std::vector<BodyStep>* bodies, ClothState& state,
                          ContactReport& report);

  bool active_ = false;                  // contact is on
  bool changed_ = false;                 // the last `resolve` had contacts
  std::vector<Vec3> start_;              // positions at the start of the contact substep [m]
  bool startIsBounded_ = false;          // whether these are small enough for a search
  std::unique_ptr<BodyContact> bodies_;  // created at first use
  ClothState unresolved_;                // predicted positions and velocities
  ClothState beforeGuard_;               // positions and velocities before the guard
  std::vector<Vec3> ahead_;              // positions extrapolated by the velocity [m]
  std::vector<ContactPoint> points_;
  ContactReport report_;                     // of the last `resolve`
  double selfSecondsBefore_ = 0.0;           // of approachOfItself, before `begin` [s]
  double bodySeconds_ = 0.0;                 // of findSubstepContacts [s]
  double selfSeconds_ = 0.0;                 // of both [s]
  std::unique_ptr<SelfContact> self_;        // created at first use
  std::unique_ptr<ExactSelfContact> exact_;  // likewise
  std::vector<SeparatingPlane> planes_;      // of bodies, for the guard
  std::vector<Vec3> unguarded_;              // positions before the guard [m]
  std::vector<Vec3> resolved_;               // positions after contact with bodies, before the guard [m]
  std::vector<Vec3> fallback_;               // positions at the start, carried along by the bodies [m]
  bool allAreCarried_ = false;               // whether all vertices move along with the same bodies
};

}  // namespace drape::sim::contact
