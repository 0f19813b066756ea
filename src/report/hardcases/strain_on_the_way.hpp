#pragma once

#include "report/hardcases/watched_cloth.hpp"

namespace drape::report::hardcases {

/// The largest elongation of an edge during the run, at each time step [-].
[[nodiscard]] double strainOnTheWay(WatchedCloth& watched, double seconds);

/// The same for Verlet at half of its limit, in double.
[[nodiscard]] double convergedStrain(const CaseTrial& trial, const CaseCloth& cloth, double seconds);

}  // namespace drape::report::hardcases
