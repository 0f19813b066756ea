#pragma once

#include "report/hardcases/watched_cloth.hpp"

namespace drape::report::hardcases {

/// Runs a free cloth for so many parts of 0.1 s, and expects that linear and angular momentum about the barycentre
/// change by at most that share of their values.
void expectMomentumKept(CaseTrial& trial, WatchedCloth& watched, int parts, double limit);

}  // namespace drape::report::hardcases
