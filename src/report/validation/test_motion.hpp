#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/stepping/stepper.hpp"

#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

namespace drape::report::validation {

/// How many substeps a method gets that has no stability limit.
enum class SubstepRule {
  One,       ///< a single one
  OfWarning  ///< as many as its warning about this cloth asks for (SolverWarning::substeps)
};

/// A cloth that a solver of the program moves.
class TestMotion {
 public:
  /// Explicit methods get the substeps for half of their stability limit.
  /// @param solver its name  @param stop ends a step by sim::StepStopped  @param rule for other methods
  TestMotion(std::shared_ptr<const sim::ClothModel> model, std::string_view solver,
             const sim::StepParameters& parameters, const std::vector<Vec3>& start, const std::stop_token& stop,
             SubstepRule rule = SubstepRule::One);

  /// Puts a body that stands still into the scene, before the first step.
  void add(sim::contact::Body body);

  void step();
  /// Takes the whole steps in that simulated time [s].
  void run(double seconds);

  [[nodiscard]] const sim::ClothModel& model() const { return *model_; }
  [[nodiscard]] const sim::ClothState& state() const { return state_; }

  /// The mean of the positions, weighted by mass [m].
  [[nodiscard]] Vec3 centre() const;
  /// The mean of the velocities, weighted by mass [m/s].
  [[nodiscard]] Vec3 velocity() const;

 private:
  std::shared_ptr<const sim::ClothModel> model_;
  sim::StepParameters parameters_;
  sim::Stepper stepper_;
  sim::ClothState state_;
  sim::StepInputs inputs_;
  std::vector<sim::contact::Body> bodies_;
  std::vector<sim::contact::BodyStep> bodySteps_;
};

/// A free oscillation about an equilibrium.
struct Oscillation {
  std::shared_ptr<const sim::ClothModel> model;
  std::vector<Vec3> equilibrium;  ///< [m]
  std::vector<Vec3> shape;        ///< of the mode, with the amplitude of the start [m]
  double period = 0.0;            ///< of the closed form [s]; only the length of the steps and of the run depends on it
};

/// The frequency of the motion's projection on the mode's shape, from its first and its third zero [1/s]. The steps are
/// a hundredth of the period. NaN if three zeros are not found within two periods.
[[nodiscard]] double frequencyOf(const Oscillation& oscillation, std::string_view solver, const std::stop_token& stop,
                                 SubstepRule rule = SubstepRule::One);

}  // namespace drape::report::validation
