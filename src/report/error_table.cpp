#include "report/error_table.hpp"

#include <fmt/core.h>

namespace drape::report {
namespace {

constexpr double millimetres = 1e3;
constexpr double percent = 100.0;

std::string stepText(const settings::Settings& settings) {
  std::string text = fmt::format("{}, time step 1/{:.6g} s", settings.solver.name, 1.0 / settings.step.timeStep);
  if (settings.step.substeps > 1) {
    text += fmt::format(" in {} substeps", settings.step.substeps);
  }
  return text;
}

std::string checkText(const Reference& reference) {
  switch (reference.kind) {
    case ReferenceKind::SameStep:
      return reference.trajectory.largestStepResidual > 0.0
                 ? fmt::format("largest residual of a step {:.2g}", reference.trajectory.largestStepResidual)
                 : fmt::format("largest residual of a solve {:.2g}", reference.trajectory.largestResidual);
    case ReferenceKind::Converged:
      return fmt::format("halving its step moved it by {:.2g} mm at most",
                         millimetres * reference.halvings.back().difference);
    case ReferenceKind::Solver:
      break;
  }
  return "not checked";
}

std::string_view kindText(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::SameStep:
      return "the same step, solved to convergence";
    case ReferenceKind::Converged:
      return "the converged motion";
    case ReferenceKind::Solver:
      break;
  }
  return "another solver";
}

std::string row(const ErrorReport& report, const CheckpointReport& at) {
  return fmt::format("{:>7.3f}{} {:>10.3g} {:>8.4f} {:>10.4g} {:>10.4g} {:>8.3g} {:>8.3f} {:>11.4g} {:>11.4g}\n",
                     at.time, at.trusted ? " " : "?", at.displacement.eps, at.displacement.squaredCosine,
                     millimetres * at.meanError, millimetres * at.rmsError, percent * at.meanError / report.diagonal,
                     at.motionKept, at.energy.total(), at.balance.integrator());
}

}  // namespace

std::string errorTable(const Measurement& measurement) {
  const ErrorReport& report = measurement.report;
  std::string text = measurement.scene->description.title + "\n";
  text += "method:    " + stepText(measurement.settings) +
          (measurement.own.restarted ? ", each interval restarted from the reference\n" : "\n");
  text += "reference: " + std::string(kindText(measurement.reference.kind)) + ": " +
          stepText(measurement.reference.settings) + "; " + checkText(measurement.reference) + "\n\n";
  text += fmt::format("{:>7}  {:>10} {:>8} {:>10} {:>10} {:>8} {:>8} {:>11} {:>11}\n", "time", "eps", "S", "mean",
                      "rms", "mean", "motion", "energy", "integrator");
  text += fmt::format("{:>7}  {:>10} {:>8} {:>10} {:>10} {:>8} {:>8} {:>11} {:>11}\n", "[s]", "[-]", "[-]", "[mm]",
                      "[mm]", "[% diag]", "kept", "[J]", "[J]");
  for (const CheckpointReport& checkpoint : report.checkpoints) {
    text += row(report, checkpoint);
  }
  for (const ErrorSummary& summary : measurement.summaries) {
    text += fmt::format(
        "\nto {:.3f} s: mean error {:.4g} mm ({:.3g} % of the diagonal), rms {:.4g} mm, motion kept {:.3f}, "
        "mean eps {:.3g}, mean S {:.4f}",
        summary.time, millimetres * summary.meanError, percent * summary.meanError / report.diagonal,
        millimetres * summary.rmsError, summary.motionKept, summary.meanEps, summary.meanSquaredCosine);
  }
  return text + (measurement.summaries.empty() ? "" : "\n");
}

}  // namespace drape::report
