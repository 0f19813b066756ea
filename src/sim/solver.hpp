#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/step_choice.hpp"
#include "sim/step_parameters.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// How a step went, for methods that iterate until something is reached or choose for themselves.
struct StepReport {
  int iterations = 0;                     ///< taken, over all substeps [-]; 0 for methods that do not count any
  double residual = 0.0;                  ///< relative residual of the last solve [-]; 0 where it is not computed
  bool converged = true;                  ///< false when a solve gave up before its tolerance
  ContactReport contact = {};             ///< what the cloth met; it is looked at once a step
  std::optional<StepChoice> choice = {};  ///< of methods that choose for themselves

  /// Takes in how the next step went.
  void add(const StepReport& next) {
    iterations += next.iterations;
    residual = next.residual;
    converged = converged && next.converged;
    if (choice && next.choice) {
      choice->add(*next.choice);
    } else if (next.choice) {
      choice = next.choice;
    }
  }
};

/// A method that advances a cloth by one time step. A solver keeps only scratch memory and what can be computed again
/// from its arguments, so that a step depends on nothing but its arguments.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// Advances positions, velocities and time of `state` by `parameters.timeStep`. Pinned vertices stay where they are,
  /// with velocity zero.
  virtual StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                          ClothState& state) = 0;

  /// The same as `count` steps one after the other, to the last bit. A solver that keeps a cloth in a form of its own
  /// converts it once only.
  virtual StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                           int count, ClothState& state);
};

/// How a solver presents itself, and what it needs.
struct SolverInfo {
  std::string_view name;                   ///< as typed by the user: "one_iteration"
  std::string_view title;                  ///< as shown: "One iteration (implicit)"
  std::string_view help;                   ///< what it is in one sentence, then what it costs and when it fails
  std::string_view source;                 ///< who published it
  bool backwardEuler = false;              ///< solves a backward-Euler step, so other integrations can stand on it
  bool choosesSubsteps = false;            ///< takes a time step in as many parts as it likes: `substeps` is not for it
  std::vector<std::string_view> settings;  ///< keys of the settings that it reads and that not every solver reads
  /// What is wrong with it on this cloth under these parameters, in words; empty when nothing is. May be null.
  std::string (*warning)(const ClothModel&, const StepParameters&) = nullptr;
  /// The longest substep [s] with which it stays stable on this cloth; 0 when there is none, infinite when any will do.
  /// Null for methods that have no such limit.
  double (*stepLimit)(const ClothModel&, const StepParameters&) = nullptr;
  std::unique_ptr<Solver> (*make)() = nullptr;
};

/// Every solver there is; the first is the paper's.
[[nodiscard]] std::span<const SolverInfo> solverTable();

/// The solver of that name, or nullptr.
[[nodiscard]] const SolverInfo* findSolver(std::string_view name);

}  // namespace drape
