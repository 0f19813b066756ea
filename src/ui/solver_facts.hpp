#pragma once

#include "text/catalogue.hpp"
#include "ui/panel_context.hpp"

#include <string>

namespace drape::ui {

/// The longest stable step [s] in words: "1/240 s", never rounded up. "none" when there is no limit.
[[nodiscard]] std::string describeStepLimit(double limit, const text::Catalogue& texts = text::Catalogue());

/// Rows about a solver: its stability limit and its last solve.
void solverRows(const PanelContext& context, const sim::SolverInfo& solver, const sim::StepParameters& parameters,
                const sim::StepReport& report);

/// The first sentence of a solver's help.
[[nodiscard]] std::string shortHelpOf(const sim::SolverInfo& solver, const text::Catalogue& texts);

/// The first sentence of a solver's help; the rest appears on hovering.
void solverHelp(const PanelContext& context, const sim::SolverInfo& solver);

}  // namespace drape::ui
