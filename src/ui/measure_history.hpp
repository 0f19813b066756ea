#pragma once

#include "session/snapshot.hpp"
#include "ui/time_samples.hpp"

#include <memory>
#include <optional>
#include <span>

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

/// The measures of the last seconds of simulated time. It starts again with another scene and after a reset. When the
/// timeline goes back, later samples stay until the simulation goes on from there.
class MeasureHistory {
 public:
  /// Length of the plots [s].
  static constexpr double window = 10.0;
  /// Length of what is kept: that of the timeline [s].
  static constexpr double kept = 60.0;
  /// Minimum distance between samples, except for the newest [s].
  static constexpr double spacing = window / 500.0;

  /// Adds the measures of a snapshot. Adding the same snapshot again changes nothing.
  void add(const session::Snapshot& snapshot);

  /// Those of the last seconds, in order of time. After a return to a time long ago, those around it.
  [[nodiscard]] std::span<const MeasureSample> samples() const { return samples_.around(window); }
  /// The time of the last snapshot, at which there is a sample [s].
  [[nodiscard]] double present() const { return samples_.present(); }

 private:
  TimeSamples<MeasureSample> samples_{kept, spacing};
  std::shared_ptr<const scene::Scene> scene_;
};

}  // namespace drape::ui
