#include "session/work_budget.hpp"

#include "settings/settings_table.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

constexpr double newest = 0.1;    // share of a new measurement in the mean
constexpr double believed = 2.0;  // most that a measurement counts as, of the mean: the machine may have been busy
constexpr double apart = 1.25;    // ratio from which on the work allowed is changed

/// To two digits: what is changed now and then need not look exact.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

std::optional<double> WorkBudget::workAfter(const Settings& settings, const ClothModel& model, const StepReport& report,
                                            double seconds) {
  const double spent = seconds - report.contact.bodySeconds - report.contact.selfSeconds;
  if (settings.automatic.budget == 0.0 || !report.choice || report.choice->forceEvaluations <= 0 || model.springs.empty() ||
      !(spent > 0.0)) {
    return std::nullopt;
  }
  const double cost = spent / (report.choice->forceEvaluations * static_cast<double>(model.springs.size()));
  cost_ = cost_ > 0.0 ? cost_ + newest * (std::min(cost, believed * cost_) - cost_) : cost;
  constexpr double milliseconds = 1e-3;
  constexpr double millions = 1e-6;
  const auto& field = std::get<NumberField>(requireSetting("auto.work").field);
  const double affordable = millions * settings.automatic.budget * milliseconds / budgetedTime / cost_;
  const double work = std::clamp(rounded(affordable), field.min, field.max);
  const double ratio = work / settings.step.costBudget;
  return ratio < apart && ratio > 1.0 / apart ? std::nullopt : std::optional(work);
}

}  // namespace drape
