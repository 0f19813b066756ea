#pragma once

#include "sim/adaptive/step_choice.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/solver_warning.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::sim {

/// Statistics of a step.
struct StepReport {
  int iterations = 0;                   ///< over all substeps [-]; 0 for methods without iterations
  double residual = 0.0;                ///< relative residual of the last solve [-]; 0 if it is not computed
  bool converged = true;                ///< false if a solve ended above its tolerance
  contact::ContactReport contact = {};  ///< contacts of the step
  double contactWork = 0.0;             ///< work of the contacts that the solver resolved in its substeps [J]
  double substepContactSeconds = 0.0;   ///< wall-clock time of these contacts [s]
  double settlingWork = 0.0;            ///< energy change by adaptive::settle [J]
  std::optional<adaptive::StepChoice> choice = {};  ///< of the solver `auto`

  /// Wall-clock time of all contacts: with bodies, of the cloth with itself, and in the substeps of the solver [s].
  [[nodiscard]] double secondsOfContact() const {
    return contact.bodySeconds + contact.selfSeconds + substepContactSeconds;
  }

  /// Adds the report of the next step.
  void add(const StepReport& next) {
    iterations += next.iterations;
    contactWork += next.contactWork;
    substepContactSeconds += next.substepContactSeconds;
    settlingWork += next.settlingWork;
    residual = next.residual;
    converged = converged && next.converged;
    if (choice && next.choice) {
      choice->add(*next.choice);
    } else if (next.choice) {
      choice = next.choice;
    }
  }
};

/// A method that advances a cloth by one time step. A solver keeps only scratch memory and cached values, so that a
/// step depends only on its arguments.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// Advances positions, velocities and time of `state` by `parameters.timeStep`. Pinned vertices stay, with zero
  /// velocity.
  virtual StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                          ClothState& state) = 0;

  /// Whether the cloth sleeps, so that `step` advances only the time.
  [[nodiscard]] virtual bool sleeps(const ClothModel& /*model*/, const StepParameters& /*parameters*/,
                                    const StepInputs& /*inputs*/, const ClothState& /*state*/) {
    return false;
  }

  /// The same as `count` single steps, bit for bit. A solver with its own data layout converts the state only once.
  virtual StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                           int count, ClothState& state);
};

/// The description of a solver. Its texts are the only ones in the simulation: they belong to the registration, so that
/// a solver is declared once, in its own file.
struct SolverInfo {
  std::string_view name;                   ///< as typed by the user: "one_iteration"
  std::string_view title;                  ///< as shown: "One iteration (implicit)"
  std::string_view help;                   ///< the method in one sentence, then its cost and limits
  std::string_view source;                 ///< publication
  bool backwardEuler = false;              ///< solves a backward-Euler step, which other integrations can use
  bool takesFabric = false;                ///< can move a cloth with a fabric (ClothModel::fabric)
  bool choosesSubsteps = false;            ///< chooses its substeps and ignores the setting `substeps`
  bool resolvesContacts = false;           ///< applies StepInputs::contacts and moves the pins in its substeps
  std::vector<std::string_view> settings;  ///< keys of the settings that it reads and that not all solvers read
  /// A warning about this cloth and these parameters, if there is one. May be null.
  std::optional<SolverWarning> (*warning)(const ClothModel&, const StepParameters&) = nullptr;
  /// The longest stable substep on this cloth [s]; 0 if there is none, infinite if every substep is stable. Null for
  /// methods without such a limit.
  double (*stepLimit)(const ClothModel&, const CommonParameters&) = nullptr;
  std::unique_ptr<Solver> (*make)() = nullptr;
};

/// All solvers; the first is the paper's.
[[nodiscard]] std::span<const SolverInfo> solverTable();

/// The solver of that name, or nullptr.
[[nodiscard]] const SolverInfo* findSolver(std::string_view name);

}  // namespace drape::sim
