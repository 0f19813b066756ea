#pragma once

#include "sim/solvers/solver.hpp"

#include <string>
#include <vector>

namespace drape::report::sections {

/// A method with one setting varied: a curve of the work-precision diagrams.
struct MethodCurve {
  std::string label;
  std::string method;              ///< the solver's name
  std::vector<std::string> fixed;  ///< "key=value"
  std::string varied;              ///< key of a setting
  std::vector<std::string> values;
  std::vector<std::string> quick;  ///< the values of a quick report
  bool fabricOnly = false;         ///< its settings have no effect on springs
};

/// The curves of all solvers. A solver that is not listed explicitly has its substeps varied.
[[nodiscard]] std::vector<MethodCurve> methodCurves();

/// Whether it has vectorised loops, and thus both precisions.
[[nodiscard]] bool hasVectorLoops(const sim::SolverInfo& solver);

}  // namespace drape::report::sections
