#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace drape {

/// A method that advances a cloth by one time step. A solver keeps only scratch memory and what can be computed again
/// from its arguments, so that a step depends on nothing but its arguments.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// Advances `state` by `parameters.timeStep`. Pinned vertices stay where they are, with velocity zero.
  virtual void step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                    ClothState& state) = 0;
};

/// How a solver presents itself.
struct SolverInfo {
  std::string_view name;   ///< as typed by the user: "one_iteration"
  std::string_view title;  ///< as shown: "One iteration (implicit)"
  std::string_view help;   ///< what it is, with its source
  std::unique_ptr<Solver> (*make)() = nullptr;
};

/// Every solver there is; the first is the default.
[[nodiscard]] std::span<const SolverInfo> solverTable();

/// The solver of that name, or nullptr.
[[nodiscard]] const SolverInfo* findSolver(std::string_view name);

}  // namespace drape
