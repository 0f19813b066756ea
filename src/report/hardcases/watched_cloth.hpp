#pragma once

#include "report/hardcases/case_trial.hpp"

namespace drape::report::hardcases {

/// Which energy must not grow without external work.
enum class EnergyRule {
  Counted,    ///< kinetic, elastic and of gravity
  WindFrame,  ///< the same with velocities relative to the air, for free cloth: air can only reduce it
  NotCounted  ///< the external work is unknown
};

/// The scene of a case's cloth.
[[nodiscard]] std::shared_ptr<const scene::Scene> sceneOf(const CaseCloth& cloth);

/// A simulation that is checked while it runs. It adds the general criteria to the results:
/// - "max distance": |x| stays below 1e5 m;
/// - "energy gained": the energy rises above its start value plus the allowed external work by at most 1 % of the
/// scene's
///   energy scale, which is m g D plus the kinetic and elastic energy at the start. D is the diagonal of the rest
///   shape. Damping of the springs can only reduce energy, so it is not counted.
/// It throws CaseEnded when the state is no longer finite.
class WatchedCloth {
 public:
  /// Explicit methods get the substeps for half of their stability limit. The solver's warning goes to the results.
  WatchedCloth(CaseTrial& trial, const CaseCloth& cloth, EnergyRule rule = EnergyRule::Counted);
  /// The same for a scene.
  WatchedCloth(CaseTrial& trial, const std::shared_ptr<const scene::Scene>& scene, EnergyRule rule);

  /// @param work allowed external work of this step [J], evaluated after it; may be empty
  void step(const std::function<double()>& work = {});
  /// Takes the whole steps in that simulated time [s].
  void run(double seconds);

  /// Applies an external command. Energy from a changed setting or a moved pin is not an error of the solver, so the
  /// balance starts again.
  void apply(const session::Command& command);

  /// Counts the energy from now on, as EnergyRule::Counted: bodies that did work stand still.
  void countEnergy();

  [[nodiscard]] const session::Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const sim::ClothModel& model() const { return simulation_.model(); }
  [[nodiscard]] const sim::ClothState& state() const { return simulation_.state(); }

 private:
  [[nodiscard]] double energy() const;
  void startEnergyCount();
  void watch();
  void keepStable();

  CaseTrial& trial_;
  EnergyRule rule_;
  session::Simulation simulation_;
  double startEnergy_ = 0.0;  // [J]
  double scale_ = 0.0;        // [J]
  double allowed_ = 0.0;      // [J]
};

/// Largest |L / l0 - 1| of a spring that has a rest length [-].
[[nodiscard]] double largestStrain(const sim::ClothModel& model, const sim::ClothState& state);

/// Largest speed of a vertex [m/s].
[[nodiscard]] double largestSpeed(const sim::ClothState& state);

}  // namespace drape::report::hardcases
