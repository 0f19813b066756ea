#pragma once

#include "sim/solver.hpp"

#include <string>
#include <vector>

namespace drape {

/// A method with one of its settings varied: a curve of the work-precision diagrams.
struct MethodCurve {
  std::string label;
  std::string method;              ///< the solver's name
  std::vector<std::string> fixed;  ///< "key=value"
  std::string varied;              ///< a setting's key
  std::vector<std::string> values;
  std::vector<std::string> quick;  ///< what a quick report takes of them
};

/// Every solver is in it: one that is not listed by hand has its substeps varied.
[[nodiscard]] std::vector<MethodCurve> methodCurves();

/// Whether it has loops of vector instructions: numbers of two precisions are offered then.
[[nodiscard]] bool hasVectorLoops(const SolverInfo& solver);

}  // namespace drape
