#pragma once

#include "session/snapshot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace drape::ui {

/// The measures at one simulated time.
struct MeasureSample {
  double time = 0.0;  ///< [s]
  sim::Energy energy;
  std::optional<sim::EnergyBalance> balance;        ///< only when it is switched on
  std::optional<double> ghostDistance;              ///< mean distance of the ghost, if there is one [m]
  std::optional<sim::adaptive::StepChoice> choice;  ///< of a solver such as auto
  std::optional<sim::Accuracy> accuracy;            ///< the last check of the error, if there is one
};

/// The measures of the last seconds of simulated time. It starts again with another scene and after a reset.
class MeasureHistory {
 public:
  /// Length of the history [s].
  static constexpr double window = 10.0;
  /// Minimum distance between samples, except for the newest [s].
  static constexpr double spacing = window / 500.0;

  /// Adds the measures of a snapshot. Adding the same snapshot again changes nothing.
  void add(const session::Snapshot& snapshot);

  /// In order of time.
  [[nodiscard]] const std::vector<MeasureSample>& samples() const { return samples_; }

 private:
  std::vector<MeasureSample> samples_;
  std::shared_ptr<const scene::Scene> scene_;
};

}  // namespace drape::ui
