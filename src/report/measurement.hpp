#pragma once

#include "report/error_report.hpp"

#include <vector>

namespace drape {

/// All that is known when a method has been held against a reference.
struct Measurement {
  const Scene* scene = nullptr;
  Settings settings;  ///< of the method
  Trajectory own;
  Reference reference;
  ErrorReport report;
  std::vector<ErrorSummary> summaries;
};

/// What to hold a method against, and for how long.
struct MeasurementPlan {
  int checkpoints = 1;  ///< of 1/30 s
  ReferenceKind against = ReferenceKind::SameStep;
  Settings reference;      ///< of the reference: sameStepSettings, convergedSettings or others
  bool restarted = false;  ///< begin each interval where the reference was
  ConvergenceTolerance tolerance;
  std::vector<double> summaryTimes{0.2, 0.5};  ///< [s]
};

/// Runs the scene under `settings` and its reference, and compares. Throws UsageError for a time step that does not fit
/// the checkpoints, InputError when method or reference blow up before the first one.
/// @param scene must outlive the measurement
[[nodiscard]] Measurement measure(const Scene& scene, const Settings& settings, const MeasurementPlan& plan,
                                  const Progress& progress = {});

}  // namespace drape
