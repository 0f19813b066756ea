#pragma once

#include "sim/contact/bodies/substeps.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/model_cache.hpp"
#include "sim/momentum.hpp"
#include "sim/solver.hpp"

#include <memory>
#include <vector>

namespace drape {

/// Advances a cloth by one time step: substeps (unless the solver chooses its own), the integration and the solver that
/// the parameters ask for. What a solver does with its step is its own; what stands around it is here, so that it need
/// not be written for each.
///
/// With S(h) a solver's backward-Euler step from (x, v):
/// - theta:  (x', v') = (x, v) + (S(theta h) - (x, v)) / theta. For theta = 1/2 this is the implicit midpoint rule.
/// - BDF2:   S(2/3 h) from (x*, v*) = 4/3 (x_n, v_n) - 1/3 (x_{n-1}, v_{n-1}). The first step, and the first after the
///   step length changed, is one of backward Euler.
///
/// With `keepMomentum`, the MomentumKeeper stands around every substep, and contact around the whole step. Pins that a
/// body carries are taken along before every substep, evenly over the step; to the solver they are at rest, as all
/// pins, and so it works in a frame that goes along with them (MovingFrame).
///
/// Near bodies a step is taken in rounds of at most 1/300 s, each with its own contact and its share of the
/// substeps. A solver that chooses its substeps keeps the energy it finds, and is fed by springs that drew cloth into a
/// body, or into itself, and that contact then made longer. So its rounds are as short as the cloth is stiff, but for
/// the fastest hundredth of the vertices: a sliver must not make the whole cloth a hundred times as expensive.
class Stepper {
 public:
  /// Throws InputError when there is no solver of that name.
  explicit Stepper(std::string_view solver);

  [[nodiscard]] const SolverInfo& info() const { return *info_; }

  /// Advances `state` by `parameters.timeStep`.
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state);

  /// What contact did in the last step, or in the last round of it.
  [[nodiscard]] const ContactStage& contact() const { return contact_; }
  /// In how many rounds the last step was taken.
  [[nodiscard]] int contactSubsteps() const { return contactSubsteps_; }
  /// Whether to keep account of what contact gives and takes in the rounds of a step, which costs two sums over the
  /// springs a round. Off at first.
  void keepContactWork(bool kept) { keepsContactWork_ = kept; }
  /// What contact gave or took in the rounds before the last one [J]; 0 where no account is kept.
  [[nodiscard]] double earlierContactWork() const { return earlierContactWork_; }

 private:
  /// Of a pin that a body carries, over the step [m].
  struct PinWay {
    std::size_t vertex = 0;
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
  };

  [[nodiscard]] int contactSubstepsOf(const ClothModel& model, const StepParameters& parameters,
                                      const StepInputs& inputs, const ClothState& state);
  /// Of a solver that keeps the energy it finds.
  [[nodiscard]] int contactSubstepsForStiffness(const ClothModel& model, const StepParameters& parameters);
  StepReport stepInContactSubsteps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                   int contactSubsteps, ClothState& state);
  /// A step, or a round of one, with contact at its end.
  StepReport stepWithContact(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                             ClothState& state);

  void planPins(const ClothModel& model, const StepInputs& inputs, const ClothState& state);
  /// Puts carried pins where they are after that share of the step.
  void movePins(double share, ClothState& state) const;
  [[nodiscard]] Vec3 meanPinVelocity(const ClothModel& model, double seconds) const;

  StepReport substep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                     ClothState& state);
  StepReport integrate(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                       ClothState& state);
  StepReport thetaStep(const ClothModel& model, StepParameters parameters, const StepInputs& inputs, ClothState& state);
  StepReport bdf2Step(const ClothModel& model, StepParameters parameters, const StepInputs& inputs, ClothState& state);

  /// For how much of a substep the velocity at its end acts on the positions [-].
  [[nodiscard]] double reachOf(const StepParameters& parameters, const ClothState& state) const;
  [[nodiscard]] Integration integrationOf(const StepParameters& parameters) const;

  const SolverInfo* info_;
  std::unique_ptr<Solver> solver_;
  ClothState before_;
  MomentumKeeper momentum_;
  ContactStage contact_;
  BodySubsteps bodySubsteps_;
  bool keepsContactWork_ = false;
  int contactSubsteps_ = 1;
  ModelCache<double> rate_;          // omega^2 / k of nearly all vertices [1/kg]
  double earlierContactWork_ = 0.0;  // [J]
  std::vector<PinWay> pinWays_;
};

}  // namespace drape
