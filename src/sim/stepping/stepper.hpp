#pragma once

#include "sim/adaptive/stretch_choice.hpp"
#include "sim/contact/bodies/substeps.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/motion/unsteady_air.hpp"
#include "sim/simd/fabric_damper.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/contact_loads.hpp"
#include "sim/stepping/seam_closing.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim {

/// Advances a cloth by one time step. It does everything around a solver: substeps (unless the solver chooses them),
/// the integration, momentum, moving pins and contact.
///
/// With S(h) a solver's backward-Euler step from (x, v):
/// - theta:  (x', v') = (x, v) + (S(theta h) - (x, v)) / theta. For theta = 1/2 this is the implicit midpoint rule.
/// - BDF2:   S(2/3 h) from (x*, v*) = 4/3 (x_n, v_n) - 1/3 (x_{n-1}, v_{n-1}). The first step, and the first after a
///   change of the step length, is a backward-Euler step.
///
/// With `keepMomentum` the MomentumKeeper corrects every substep. Contact acts at the end of the step. Moving pins
/// move before every substep, evenly over the step. Solvers assume pins at rest, so they work in a frame that moves
/// with the pins (MovingFrame). `auto` moves pins that move differently in its own substeps.
///
/// The damping of a fabric acts at the start of the step (FabricDamper), for every solver. All else then starts from
/// the damped velocities.
///
/// Near bodies a step is divided into contact substeps of at most 1/300 s. Each has its own contact and its part of the
/// substeps. Contact at the end of a contact substep moves cloth that the solver has pulled into a body or into itself,
/// and stretches its springs; a solver that conserves energy would keep that energy. So `auto` gets the contacts at the
/// start of each contact substep and applies their impulses in its own substeps (SolverInfo::resolvesContacts). Contact
/// at the end then corrects what is left.
///
/// Flat pieces that fall freely get the unsteady forces of the air (UnsteadyAir) after the solver's part of a contact
/// substep. Near a body the air cannot flow around them, so they do not get these forces there. A step is divided into
/// contact substeps that resolve their motion.
///
/// Seams that are not welded yet are drawn together in the same way (SeamClosing): in the substeps of a solver that
/// resolves contacts, and before contact at the end of each contact substep.
class Stepper {
 public:
  /// Throws UnknownSolver if there is no solver of that name.
  explicit Stepper(std::string_view solver);

  [[nodiscard]] const SolverInfo& info() const { return *info_; }

  /// Advances `state` by `parameters.timeStep`. A cloth with a fabric ignores the material of the parameters, which is
  /// that of springs. Throws NoFabricSolver if the solver takes springs only.
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state);

  /// Draws these seams together in the following steps. They must exist until then. Cloth with an open seam does not
  /// sleep.
  void drawTogether(std::span<const Seam> seams) { seams_ = seams; }

  /// Contact in the last step, or in its last contact substep.
  [[nodiscard]] const contact::ContactStage& contact() const { return contact_; }
  /// Number of contact substeps of the last step.
  [[nodiscard]] int contactSubsteps() const { return contactSubsteps_; }
  /// Whether to measure the energy change by contact in the contact substeps, which costs two sums over the springs in
  /// each. Off by default.
  void keepContactWork(bool kept) { keepsContactWork_ = kept; }
  /// Energy change by contact in the last step [J], without that at its end: the work of contacts that the solver
  /// resolved, and, if it is measured, the corrections in the contact substeps before the last one. The work of seams
  /// that close is part of it.
  [[nodiscard]] double earlierContactWork() const { return earlierContactWork_; }
  /// Energy change in the last step by the damping of the fabric and by settling [J].
  [[nodiscard]] double dampingWork() const { return dampingWork_; }
  /// Energy change in the last step by the unsteady forces of the air [J].
  [[nodiscard]] double unsteadyAirWork() const { return unsteadyAirWork_; }
  /// Whether to keep the loads of contacts on the vertices. Off by default. Does not change the motion.
  void keepContactLoads(bool kept);
  /// The loads of contacts in the last step. While the cloth sleeps, those of the last step before. Unknown before the
  /// first step that keeps them.
  [[nodiscard]] const ContactLoads& contactLoads() const { return contactLoads_; }

 private:
  /// The motion of a pin on a body over the step [m].
  struct PinMotion {
    std::size_t vertex = 0;
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
  };

  [[nodiscard]] int contactSubstepsOf(const ClothModel& model, const StepParameters& parameters,
                                      const StepInputs& inputs, const ClothState& state);
  [[nodiscard]] int unsteadyAirSubsteps(const ClothModel& model, const StepParameters& parameters,
                                        const StepInputs& inputs, const ClothState& state);
  StepReport stepInContactSubsteps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                   int contactSubsteps, ClothState& state);
  /// The step with the material that acts on the cloth (actingMaterial).
  StepReport advance(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                     ClothState& state);
  StepReport stepInParts(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                         ClothState& state);
  StepReport stepInShorterParts(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                ClothState& state);
  StepReport stepAsleep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                        ClothState& state);
  /// A step, or a contact substep, with contact at its end.
  StepReport stepWithContact(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                             ClothState& state);

  /// The solver's part of a step, without contact at its end.
  StepReport moveBySolver(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                          ClothState& state);
  /// The same, repeated while contacts were missing in the substeps.
  StepReport moveWithSubstepContacts(const ClothModel& model, const StepParameters& parameters, StepInputs inputs,
                                     ClothState& state);

  /// Stores what the unsteady forces of the air need at the start of a contact substep.
  void beginUnsteadyAir(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                        const ClothState& state);
  /// Draws the seams together at the end of a contact substep.
  void closeSeams(const ClothModel& model, const StepParameters& parameters, ClothState& state);
  /// Adds the loads of a contact substep.
  void addContactLoads(const ClothModel& model, const ClothState& state);
  /// The inputs of the solver in a contact substep, with the contacts that it resolves.
  [[nodiscard]] StepInputs inputsOfSolver(const ClothModel& model, const StepParameters& parameters,
                                          const StepInputs& inputs, ClothState& state);
  /// Moves the surfaces of the contacts to the end of a substep.
  void advanceSubstepContacts(double timeStep);
  void planPins(const ClothModel& model, const StepInputs& inputs, const ClothState& state);
  /// Moves pins on bodies to their positions after that fraction of the step.
  StepReport stepInFrameOfPins(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                               int substeps, ClothState& state);
  void movePins(double fraction, ClothState& state) const;
  [[nodiscard]] std::vector<MovedPin> pinDisplacements(int substeps) const;
  [[nodiscard]] Vec3 meanPinVelocity(const ClothModel& model, double seconds) const;

  StepReport substep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                     ClothState& state);
  StepReport integrate(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                       ClothState& state);
  StepReport thetaStep(const ClothModel& model, StepParameters parameters, const StepInputs& inputs, ClothState& state);
  StepReport bdf2Step(const ClothModel& model, StepParameters parameters, const StepInputs& inputs, ClothState& state);

  /// The fraction of a substep for which the velocity at its end acts on the positions [-].
  [[nodiscard]] double driftFraction(const StepParameters& parameters, const ClothState& state) const;
  [[nodiscard]] Integration integrationOf(const StepParameters& parameters) const;

  /// Damps a fabric over the step; nothing for springs or without damping.
  void dampFabric(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state);

  /// The cloth with the stretch stiffness that the solver chooses.
  StepReport advanceWithChosenStretch(const ClothModel& model, const StepParameters& parameters,
                                      const StepInputs& inputs, ClothState& state);

  const SolverInfo* info_;
  std::unique_ptr<Solver> solver_;
  ClothState before_;
  ModelCache<double> meanEdge_;                               // [m]
  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;  // the free ones
  MomentumKeeper momentum_;
  contact::ContactStage contact_;
  contact::BodySubsteps bodySubsteps_;
  bool keepsContactWork_ = false;
  bool keepsContactLoads_ = false;
  bool contactLoadsAreOld_ = true;  // of an earlier step
  ContactLoads contactLoads_;
  int contactSubsteps_ = 1;
  adaptive::StretchChoice stretch_;
  std::unique_ptr<simd::FabricDamper> damper_;  // null until a fabric damps
  double earlierContactWork_ = 0.0;             // [J]
  double dampingWork_ = 0.0;                    // [J]
  UnsteadyAir unsteadyAir_;
  double unsteadyAirWork_ = 0.0;  // [J]
  std::vector<PinMotion> pinMotions_;
  std::vector<SubstepContact> substepContacts_;  // of the present contact substep; those of seams come last
  std::size_t seamContacts_ = 0;                 // how many of these are of seams
  std::vector<SubstepContact> startContacts_;    // the same contacts at the start of the contact substep
  ClothState contactStart_;                      // from which a contact substep or a step is repeated
  double largestCorrection_ = 0.0;               // of a vertex by contact in the contact substeps of the step [m]
  std::span<const Seam> seams_;                  // that are not welded
  SeamClosing closing_;
};

}  // namespace drape::sim
