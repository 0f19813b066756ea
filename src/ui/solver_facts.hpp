#pragma once

#include "ui/panel_context.hpp"

#include <string>

namespace drape {

/// A longest stable step [s] as people write it: "1/240 s", never rounded to what is too long. "none" when there is no
/// limit.
[[nodiscard]] std::string describeStepLimit(double limit);

/// Rows about a solver: how long its steps may be, how its last solve went.
void solverRows(const PanelContext& context, const SolverInfo& solver, const StepParameters& parameters,
                const StepReport& report);

/// What a solver is, in the first sentence of its help; the rest appears on hovering.
void solverHelp(const PanelContext& context, const SolverInfo& solver);

}  // namespace drape
