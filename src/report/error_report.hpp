#pragma once

#include "report/references.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/measures.hpp"

#include <span>
#include <vector>

namespace drape::report {

/// Linear and angular momentum of a cloth.
struct Momentum {
  Vec3 linear = Vec3::Zero();   ///< [kg m/s]
  Vec3 angular = Vec3::Zero();  ///< about the barycentre [kg m^2/s]
};

/// The errors of a method against a reference at one checkpoint (docs/theory/measures.md).
struct CheckpointReport {
  double time = 0.0;                    ///< [s]
  sim::DisplacementError displacement;  ///< of the interval that ends here
  double meanError = 0.0;               ///< mean distance of the positions [m]
  double rmsError = 0.0;                ///< root of their mean square [m]
  double motionKept = 0.0;              ///< of the interval [-]
  double maxStretch = 0.0;              ///< [-]
  sim::Energy energy;                   ///< [J]
  sim::EnergyBalance balance;           ///< since the start, or over the interval when restarted
  Momentum momentum;                    ///< of the method
  Momentum referenceMomentum;           ///< of the reference
  double referenceStretch = 0.0;        ///< largest, of the reference [-]
  sim::Energy referenceEnergy;          ///< [J]
  bool trusted = true;                  ///< whether the reference passed its check here
};

/// The errors of a method over a run.
struct ErrorReport {
  double diagonal = 0.0;                      ///< of the rest shape [m]
  std::vector<CheckpointReport> checkpoints;  ///< from 1/30 s on
};

/// The main errors of a run up to a time.
struct ErrorSummary {
  double time = 0.0;               ///< of the last checkpoint included [s]
  double meanEps = 0.0;            ///< mean over the checkpoints so far [-]
  double meanSquaredCosine = 0.0;  ///< as above [-]
  double meanError = 0.0;          ///< at that time [m]
  double rmsError = 0.0;           ///< at that time [m]
  double motionKept = 0.0;         ///< over the run so far [-]
};

/// Compares `own` with `reference`, up to the end of the shorter one.
/// @param parameters of the method, for its energies
[[nodiscard]] ErrorReport compareWithReference(const sim::ClothModel& model, const sim::StepParameters& parameters,
                                               const Trajectory& own, const Reference& reference);

/// The summary at the checkpoint nearest to each of these times [s]. It omits times beyond the run and checkpoints
/// without valid vertices.
[[nodiscard]] std::vector<ErrorSummary> summarise(const sim::ClothModel& model, const Trajectory& own,
                                                  const Reference& reference, const ErrorReport& report,
                                                  std::span<const double> times);

}  // namespace drape::report
