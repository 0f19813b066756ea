#include "ui/solver_facts.hpp"

#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace drape::ui {
namespace {

bool solvesToATolerance(const sim::SolverInfo& solver) {
  return std::find(solver.settings.begin(), solver.settings.end(), "tolerance") != solver.settings.end();
}

}  // namespace

std::string describeStepLimit(double limit) {
  constexpr double longStep = 0.5;  // [s]
  if (!std::isfinite(limit)) {
    return "none";
  }
  if (limit >= longStep) {
    return text::formatQuantity(limit, "s");
  }
  // Slightly less than the inverse, so that rounding does not turn 1/240 s into 1/241 s.
  return "1/" + text::formatCount(std::llround(std::ceil(1.0 / limit * (1.0 - 1e-9)))) + " s";
}

void solverRows(const PanelContext& context, const sim::SolverInfo& solver, const sim::StepParameters& parameters,
                const sim::StepReport& report) {
  if (solver.stepLimit != nullptr) {
    const double limit = solver.stepLimit(*context.snapshot.model, parameters);
    const bool beyond = parameters.timeStep / parameters.substeps > limit * (1.0 + 1e-9);
    valueRow(context, "Stability limit", describeStepLimit(limit), beyond ? palette().warning : palette().text);
  }
  // The row exists from the start, so that the first step does not move the rows below.
  if (report.iterations > 0 || solvesToATolerance(solver)) {
    valueRow(context, "Iterations", text::formatCount(report.iterations));
    if (solvesToATolerance(solver)) {
      const std::string residual = text::formatNumber(report.residual);
      valueRow(context, "Residual", report.converged ? residual : residual + ", did not converge",
               report.converged ? palette().text : palette().warning);
    }
  }
}

void solverHelp(const PanelContext& context, const sim::SolverInfo& solver) {
  mutedText(solver.help.substr(0, solver.help.find(". ") + 1));
  explainItem(context, "help." + std::string(solver.name), solver.help);
}

}  // namespace drape::ui
