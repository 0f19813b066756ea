#pragma once

#include "scene/scene.hpp"
#include "sim/solvers/solver.hpp"

namespace drape::report::sections {

/// The number of substeps of the settings' time step with which a method is stable, with a margin of 10 %. 1 for a
/// method without a limit.
[[nodiscard]] int stableSubsteps(const sim::SolverInfo& solver, const sim::ClothModel& model,
                                 const sim::StepParameters& parameters);

}  // namespace drape::report::sections
