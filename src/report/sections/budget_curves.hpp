#pragma once

#include "report/sections/method_curves.hpp"
#include "scene/scene.hpp"

#include <vector>

namespace drape::report::sections {

/// The settings among which a method for a time budget is chosen: those methods that the comparison of all methods
/// (methodCurves) finds on its fronts, in float where they can, each with one setting that buys smaller errors for more
/// time, the cheapest first.
[[nodiscard]] std::vector<MethodCurve> budgetCurves(const scene::Scene& scene);

}  // namespace drape::report::sections
