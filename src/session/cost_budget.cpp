#include "session/cost_budget.hpp"

#include "settings/settings_table.hpp"

#include <algorithm>
#include <cmath>

namespace drape::session {
namespace {

constexpr double newestWeight = 0.1;  // of a measurement in the running mean
// A measurement counts at most this many times the mean: the machine may have been busy.
constexpr double largestRatio = 2.0;
constexpr double changeRatio = 1.25;  // the cost budget changes when it is off by this factor

/// Rounds to two digits, since the budget changes only now and then.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

std::optional<double> CostBudget::budgetAfter(const settings::Settings& settings, const sim::ClothModel& model,
                                              const sim::StepReport& report, double seconds) {
  const double spent = seconds - report.secondsOfContact();
  if (settings.automatic.budget == 0.0 || !report.choice || report.choice->forceEvaluations <= 0 ||
      model.springs.empty() || !(spent > 0.0)) {
    return std::nullopt;
  }
  const double cost = spent / (report.choice->forceEvaluations * static_cast<double>(model.springs.size()));
  cost_ = cost_ > 0.0 ? cost_ + newestWeight * (std::min(cost, largestRatio * cost_) - cost_) : cost;
  constexpr double milliseconds = 1e-3;
  constexpr double millions = 1e-6;
  const auto& field = std::get<settings::NumberField>(settings::requireSetting("auto.cost").field);
  const double affordable = millions * settings.automatic.budget * milliseconds / budgetedTime / cost_;
  const double budget = std::clamp(rounded(affordable), field.min, field.max);
  const double ratio = budget / settings.step.automatic.costBudget;
  return ratio < changeRatio && ratio > 1.0 / changeRatio ? std::nullopt : std::optional(budget);
}

}  // namespace drape::session
