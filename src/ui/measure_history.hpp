#pragma once

#include "session/snapshot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace drape {

/// What was measured at one moment of the simulated time.
struct MeasureSample {
  double time = 0.0;  ///< [s]
  Energy energy;
  std::optional<EnergyBalance> balance;  ///< where it was asked for
  std::optional<double> ghostDistance;   ///< mean distance of the ghost, where there is one [m]
  std::optional<StepChoice> choice;      ///< of a solver that chooses for itself
};

/// The measures of the last seconds of simulated time. Begins anew with another scene and when the cloth is reset.
class MeasureHistory {
 public:
  /// How far back it reaches [s].
  static constexpr double window = 10.0;
  /// Samples are no nearer to each other than this [s], but for the newest.
  static constexpr double spacing = window / 500.0;

  /// Takes what a snapshot says; the same snapshot again changes nothing.
  void add(const Snapshot& snapshot);

  /// The oldest first; times grow.
  [[nodiscard]] const std::vector<MeasureSample>& samples() const { return samples_; }

 private:
  std::vector<MeasureSample> samples_;
  std::shared_ptr<const Scene> scene_;
};

}  // namespace drape
