#pragma once

#include "settings/settings.hpp"
#include "sim/cloth_model.hpp"
#include "sim/solver.hpp"

#include <optional>

namespace drape {

/// What a screen shows at a time: the time for which `auto.budget` is given [s].
inline constexpr double budgetedTime = 1.0 / 60.0;

/// Turns the computing time that `auto` may take into the work that it may do, from what its steps were measured to
/// cost. The clock decides nothing within a step: what follows from it becomes a command, which goes into the log.
class WorkBudget {
 public:
  /// Takes in what a step cost by the clock, contact included [s].
  /// @return the work that the time allowed pays for [1e6/s], when that is a fifth or more off what is in force
  [[nodiscard]] std::optional<double> workAfter(const Settings& settings, const ClothModel& model,
                                                const StepReport& report, double seconds);

 private:
  double cost_ = 0.0;  // of one evaluation of a spring, lately [s]; 0: not known
};

}  // namespace drape
