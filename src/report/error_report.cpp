#include "report/error_report.hpp"

#include "sim/motion/momentum.hpp"

#include <algorithm>
#include <cmath>

namespace drape::report {
namespace {

/// The two motions over the interval that ends at checkpoint k. A restarted run began it at the reference.
sim::CheckpointPair pairAt(const Trajectory& own, const Trajectory& reference, std::size_t k) {
  const std::vector<Vec3>& referenceBefore = reference.states[k - 1].positions;
  const std::vector<Vec3>& before = own.restarted ? referenceBefore : own.states[k - 1].positions;
  return {before, own.states[k].positions, referenceBefore, reference.states[k].positions};
}

/// The mean of the valid values; not a number without any.
class Mean {
 public:
  void add(double value) {
    if (std::isfinite(value)) {
      sum_ += value;
      ++count_;
    }
  }
  [[nodiscard]] double value() const { return sum_ / count_; }

 private:
  double sum_ = 0.0;
  double count_ = 0.0;
};

Momentum momentumOf(const sim::ClothModel& model, const sim::ClothState& state) {
  return {sim::linearMomentum(model, state), sim::angularMomentum(model, state, sim::barycentreOf(model, state))};
}

}  // namespace

ErrorReport compareWithReference(const sim::ClothModel& model, const sim::StepParameters& parameters,
                                 const Trajectory& own, const Reference& reference) {
  const Trajectory& truth = reference.trajectory;
  ErrorReport report;
  report.diagonal = sim::diagonalOf(model);
  const std::size_t count = std::min(own.states.size(), truth.states.size());
  for (std::size_t k = 1; k < count; ++k) {
    const sim::CheckpointPair pair = pairAt(own, truth, k);
    CheckpointReport checkpoint;
    checkpoint.time = static_cast<double>(k) * checkpointInterval;
    checkpoint.displacement = sim::displacementError(model, pair, report.diagonal);
    checkpoint.meanError = sim::meanDistance(pair.after, pair.referenceAfter);
    checkpoint.rmsError = sim::rmsDistance(pair.after, pair.referenceAfter);
    checkpoint.motionKept = sim::motionKept(model, pair);
    checkpoint.maxStretch = sim::maxStretch(model, own.states[k]);
    checkpoint.energy = sim::energyOf(model, parameters, own.states[k]);
    checkpoint.balance = k < own.balances.size() ? own.balances[k] : sim::EnergyBalance{};
    checkpoint.momentum = momentumOf(model, own.states[k]);
    checkpoint.referenceMomentum = momentumOf(model, truth.states[k]);
    checkpoint.referenceStretch = sim::maxStretch(model, truth.states[k]);
    checkpoint.referenceEnergy = sim::energyOf(model, reference.settings.step, truth.states[k]);
    checkpoint.trusted = static_cast<int>(k) <= reference.trusted;
    report.checkpoints.push_back(checkpoint);
  }
  return report;
}

std::vector<ErrorSummary> summarise(const sim::ClothModel& model, const Trajectory& own, const Reference& reference,
                                    const ErrorReport& report, std::span<const double> times) {
  std::vector<ErrorSummary> summaries;
  for (const double time : times) {
    const auto last = static_cast<std::size_t>(std::max(0.0, std::round(time / checkpointInterval)));
    if (last < 1 || last > report.checkpoints.size()) {
      continue;
    }
    Mean eps;
    Mean squaredCosine;
    sim::MotionKept kept;
    for (std::size_t k = 1; k <= last; ++k) {
      eps.add(report.checkpoints[k - 1].displacement.eps);
      squaredCosine.add(report.checkpoints[k - 1].displacement.squaredCosine);
      kept.add(model, pairAt(own, reference.trajectory, k));
    }
    const CheckpointReport& end = report.checkpoints[last - 1];
    summaries.push_back({end.time, eps.value(), squaredCosine.value(), end.meanError, end.rmsError, kept.value()});
  }
  return summaries;
}

}  // namespace drape::report
