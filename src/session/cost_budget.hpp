#pragma once

#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/solvers/solver.hpp"

#include <optional>

namespace drape::session {

/// The time of motion to which `auto.budget` refers: one frame of a screen [s].
inline constexpr double budgetedTime = 1.0 / 60.0;

/// Converts the time budget of `auto` into a cost budget, from the measured cost of its steps. The clock decides
/// nothing within a step: a change becomes a command, and the log records it.
class CostBudget {
 public:
  /// Adds the measured duration of a step, contact included [s].
  /// @return the cost budget that fits the time budget [1e6/s], when it is off by a fifth or more
  [[nodiscard]] std::optional<double> budgetAfter(const settings::Settings& settings, const sim::ClothModel& model,
                                                  const sim::StepReport& report, double seconds);

 private:
  double cost_ = 0.0;  // of one spring evaluation, recently [s]; 0: not known
};

}  // namespace drape::session
