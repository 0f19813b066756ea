#pragma once

#include "report/hardcases/watched_cloth.hpp"

namespace drape::report::hardcases {

/// The largest elongation of an edge during the run, at each time step [-].
[[nodiscard]] double maxStrainOfRun(WatchedCloth& watched, double seconds);

/// Runs, and expects that this strain is at most that multiple of the strain of the converged solve: that of Verlet at
/// half of its limit, in double.
void expectStrain(CaseTrial& trial, const CaseCloth& cloth, double seconds, double limit);

}  // namespace drape::report::hardcases
