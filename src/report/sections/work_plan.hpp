#pragma once

#include "report/sections/method_curves.hpp"
#include "report/sections/set_ups.hpp"
#include "report/sections/work_material.hpp"
#include "sim/solvers/solver.hpp"

#include <vector>

namespace drape::report::sections {

/// A cloth for the comparison of methods.
struct ComparedCloth {
  int resolution = 0;  ///< 0 for a mesh
  WorkMaterial material;
  bool fastMethods = false;  ///< only methods with vector instructions for this material
};

/// The cloths of a set-up. The first set-up has most of them, and a quick report has few.
[[nodiscard]] std::vector<ComparedCloth> comparedCloths(const SetUp& setUp, bool isFirst, bool quick);

/// The values of a curve that are measured on the cloth.
[[nodiscard]] std::vector<std::string> valuesOn(const ComparedCloth& cloth, const MethodCurve& curve, bool quick);

/// Whether the solver is among those that are compared on the cloth.
[[nodiscard]] bool takes(const sim::SolverInfo& solver, const ComparedCloth& cloth);

/// Whether the curve is measured on the cloth: its solver is, and its settings have an effect.
[[nodiscard]] bool isMeasuredOn(const ComparedCloth& cloth, const MethodCurve& curve);

}  // namespace drape::report::sections
