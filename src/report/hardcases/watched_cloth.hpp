#pragma once

#include "report/hardcases/case_trial.hpp"

namespace drape {

/// Which energy may not grow by itself.
enum class EnergyRule {
  Counted,    ///< kinetic, elastic and of gravity
  WindFrame,  ///< the same with velocities against the air, for cloth that nothing holds: air can only take from it
  NotCounted  ///< nothing is known of the work done from outside
};

/// A simulation that is watched while it runs. What every case asks goes into the trial's figures:
/// - "farthest": |x| stays below 1e5 m;
/// - "energy gained": the energy rises above where it began, and what was allowed as work from outside, by at most 1 %
///   of the scene's energy scale, which is m g D plus the kinetic and elastic energy at the beginning. D is the
///   diagonal of the rest shape. Springs' damping can only take energy, so it is not counted.
/// When the state stops being finite, CaseEnded is thrown.
class WatchedCloth {
 public:
  /// Explicit methods get as many substeps as their own stability limit asks for, to half of it.
  WatchedCloth(CaseTrial& trial, const CaseCloth& cloth, EnergyRule rule = EnergyRule::Counted);

  /// @param work that may have been done from outside in this step [J], asked after it; may be empty
  void step(const std::function<double()>& work = {});
  /// The whole steps in that simulated time [s].
  void run(double seconds);

  /// A command from outside. What energy a changed setting or a moved pin brings or takes is not the solver's doing:
  /// the account begins anew.
  void apply(const Command& command);

  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const ClothModel& model() const { return simulation_.model(); }
  [[nodiscard]] const ClothState& state() const { return simulation_.state(); }

 private:
  [[nodiscard]] double energy() const;
  void countAnew();
  void watch();
  void keepStable();

  CaseTrial& trial_;
  EnergyRule rule_;
  Simulation simulation_;
  double startEnergy_ = 0.0;  // [J]
  double scale_ = 0.0;        // [J]
  double allowed_ = 0.0;      // [J]
};

/// Largest |L / l0 - 1| of a spring that has a rest length [-].
[[nodiscard]] double largestStrain(const ClothModel& model, const ClothState& state);

/// Largest speed of a vertex [m/s].
[[nodiscard]] double largestSpeed(const ClothState& state);

}  // namespace drape
