#pragma once

#include "report/error_report.hpp"

#include <vector>

namespace drape::report {

/// The complete result of comparing a method with a reference.
struct Measurement {
  const scene::Scene* scene = nullptr;
  settings::Settings settings;  ///< of the method
  Trajectory own;
  Reference reference;
  ErrorReport report;
  std::vector<ErrorSummary> summaries;
};

/// What to compare a method with, and for how long.
struct MeasurementPlan {
  int checkpoints = 1;  ///< number of intervals of 1/30 s
  ReferenceKind against = ReferenceKind::SameStep;
  settings::Settings reference;  ///< of the reference: sameStepSettings, convergedSettings or others
  bool restarted = false;        ///< start each interval at the reference
  ConvergenceTolerance tolerance;
  std::vector<double> summaryTimes{0.2, 0.5};  ///< [s]
};

/// Runs the scene under `settings` and its reference, and compares them. Throws UsageError for a time step that does
/// not fit the checkpoints, InputError when method or reference blow up before the first one.
/// @param scene must outlive the measurement
[[nodiscard]] Measurement measure(const scene::Scene& scene, const settings::Settings& settings,
                                  const MeasurementPlan& plan, const Progress& progress = {});

}  // namespace drape::report
