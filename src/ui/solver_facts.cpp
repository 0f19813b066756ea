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

std::string describeStepLimit(double limit, const text::Catalogue& texts) {
  constexpr double longStep = 0.5;  // [s]
  if (!std::isfinite(limit)) {
    return texts("none");
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
    valueRow(context, "Stability limit", describeStepLimit(limit, context.texts),
             beyond ? palette().warning : palette().text);
  }
  // The row exists from the start, so that the first step does not move the rows below.
  if (report.iterations > 0 || solvesToATolerance(solver)) {
    valueRow(context, "Iterations", text::formatCount(report.iterations));
    if (solvesToATolerance(solver)) {
      const std::string residual = text::formatNumber(report.residual);
      valueRow(context, "Residual", report.converged ? residual : context.texts("{}, did not converge", residual),
               report.converged ? palette().text : palette().warning);
    }
  }
}

std::string shortHelpOf(const sim::SolverInfo& solver, const text::Catalogue& texts) {
  const std::string help = texts(solver.help);
  return help.substr(0, help.find(". ") + 1);
}

void solverHelp(const PanelContext& context, const sim::SolverInfo& solver) {
  mutedText(shortHelpOf(solver, context.texts));
  explainItem(context, "help." + std::string(solver.name), solver.help);
}

}  // namespace drape::ui
