#include "report/sections/stable_substeps.hpp"

#include <cmath>

namespace drape::report::sections {

int stableSubsteps(const sim::SolverInfo& solver, const sim::ClothModel& model, const sim::StepParameters& parameters) {
  constexpr double safely = 0.9;
  constexpr double finestStep =
      1.0 / 30000.0;  // of the paper's explicit reference, for a method that is never stable [s]
  if (solver.stepLimit == nullptr) {
    return 1;
  }
  const double limit = solver.stepLimit(model, parameters);
  const double longest = limit > 0.0 ? safely * limit : finestStep;
  return std::isfinite(longest) ? static_cast<int>(std::ceil(parameters.timeStep / longest * (1.0 - 1e-9))) : 1;
}

}  // namespace drape::report::sections
