#include "report/measurement.hpp"

#include "messages/blow_up_text.hpp"
#include "messages/error.hpp"

namespace drape::report {
namespace {

Reference runReference(const scene::Scene& scene, const MeasurementPlan& plan, const Trajectory* compared,
                       const Progress& progress) {
  ConvergenceTolerance tolerance = plan.tolerance;
  tolerance.compared = compared;
  switch (plan.against) {
    case ReferenceKind::SameStep:
      return sameStepReference(scene, plan.reference, plan.checkpoints, progress);
    case ReferenceKind::Converged:
      return convergedReference(scene, plan.reference, plan.checkpoints, tolerance, progress);
    case ReferenceKind::Solver:
      break;
  }
  return solverReference(scene, plan.reference, plan.checkpoints, progress);
}

}  // namespace

Measurement measure(const scene::Scene& scene, const settings::Settings& settings, const MeasurementPlan& plan,
                    const Progress& progress) {
  const Watch watch{.energy = true, .stepResiduals = false, .label = "method", .progress = progress};
  Measurement measurement;
  measurement.scene = &scene;
  measurement.settings = settings;
  if (plan.restarted) {
    measurement.reference = runReference(scene, plan, nullptr, progress);
    measurement.own = runRestarted(scene, settings, measurement.reference.trajectory, watch);
  } else {
    measurement.own = runTrajectory(scene, settings, plan.checkpoints, watch);
    measurement.reference = runReference(scene, plan, &measurement.own, progress);
  }
  if (measurement.own.checkpoints() < 1) {
    throw messages::InputError("the cloth blew up before the first checkpoint. " +
                               messages::remedyForBlowUp(*scene.model));
  }
  measurement.report = compareWithReference(*scene.model, settings.step, measurement.own, measurement.reference);
  measurement.summaries =
      summarise(*scene.model, measurement.own, measurement.reference, measurement.report, plan.summaryTimes);
  return measurement;
}

}  // namespace drape::report
