#include "report/sections/equal_cost.hpp"

#include "report/number_text.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr const char* own = "auto";
constexpr double finest = 1e-9;  // resolution of errors [m]

double costOf(const ReportRow& row) {
  return numberIn(row, "us_per_simulated_second");
}

/// The error of a setting [m]: the median of all starts where there are several, since a single one is accidental.
double errorOf(const ReportRow& row) {
  const double median = numberIn(row, "error_median");
  return std::isfinite(median) ? median : numberIn(row, "error_mean");
}

/// The level below which errors are meaningless [m].
double floorOf(const ReportRows& rows) {
  double floor = finest;
  for (const ReportRow& row : rows) {
    for (const char* key : {"noise_floor", "reference_difference"}) {
      const double value = numberIn(row, key);
      floor = value > floor ? value : floor;
    }
  }
  return floor;
}

/// The setting with the smallest error within the cost, of `auto` or of all others; null when there is none.
const ReportRow* bestWithin(double cost, bool ofOwn, const ReportRows& rows) {
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    const bool fits = isCalmRow(row) && (row.value("method", "") == own) == ofOwn && costOf(row) <= cost;
    if (fits && (best == nullptr || errorOf(row) < errorOf(*best))) {
      best = &row;
    }
  }
  return best;
}

/// A setting of `auto` and its rival at equal cost.
struct Pairing {
  const ReportRow* setting = nullptr;
  const ReportRow* rival = nullptr;
  double ratio = 0.0;  ///< of their errors [-]
};

std::vector<Pairing> pairingsIn(const ReportRows& rows) {
  const double floor = floorOf(rows);
  std::vector<Pairing> pairings;
  for (const ReportRow& row : rows) {
    const bool counts = isCalmRow(row) && row.value("method", "") == own;
    const ReportRow* rival = counts ? bestWithin(costOf(row), false, rows) : nullptr;
    if (rival != nullptr) {
      const ReportRow* best = bestWithin(costOf(row), true, rows);
      const double ratio = std::max(floor, errorOf(*best)) / std::max(floor, errorOf(*rival));
      pairings.push_back({best, rival, ratio});
    }
  }
  return pairings;
}

void copy(ReportRow& row, const char* to, const ReportRow* from, const char* key) {
  row[to] = from == nullptr ? ReportRow(nullptr) : (*from)[key];
}

/// "auto.cost=3 auto.soften=on" and its cost.
std::string settingText(const ReportRow& row) {
  return row.value("setting", "") + " (" + frameCost(row) + " ms a frame)";
}

}  // namespace

ReportRow equalCostRow(const ReportRows& rows, ReportRow row) {
  const std::vector<Pairing> pairings = pairingsIn(rows);
  const auto upTo = [&](double ratio) {
    return std::count_if(pairings.begin(), pairings.end(), [&](const Pairing& one) { return one.ratio <= ratio; });
  };
  const auto found = std::max_element(pairings.begin(), pairings.end(),
                                      [](const Pairing& a, const Pairing& b) { return a.ratio < b.ratio; });
  const Pairing worst = found == pairings.end() ? Pairing{} : *found;
  row["method"] = own;
  copy(row, "setting", worst.setting, "setting");
  copy(row, "us_per_simulated_second", worst.setting, "us_per_simulated_second");
  row["error_mean"] = row["error_of_diagonal"] = nullptr;
  if (worst.setting != nullptr) {
    const double error = errorOf(*worst.setting);
    row["error_mean"] = error;
    row["error_of_diagonal"] =
        numberIn(*worst.setting, "error_of_diagonal") * error / numberIn(*worst.setting, "error_mean");
  }
  row["points"] = pairings.size();
  row["within"] = upTo(maxErrorRatio);
  row["best"] = upTo(1.0);
  row["ratio"] = worst.rival == nullptr ? ReportRow(nullptr) : ReportRow(worst.ratio);
  copy(row, "by_method", worst.rival, "method");
  copy(row, "by_setting", worst.rival, "setting");
  row["by_error_mean"] = worst.rival == nullptr ? ReportRow(nullptr) : ReportRow(errorOf(*worst.rival));
  return row;
}

std::vector<Block> equalCostBlocks(const ReportRows& answers) {
  int points = 0;
  int within = 0;
  int best = 0;
  ReportRows behind;
  for (const ReportRow& row : answers) {
    points += row.value("points", 0);
    within += row.value("within", 0);
    best += row.value("best", 0);
    if (numberIn(row, "ratio") > maxErrorRatio) {
      behind.push_back(row);
    }
  }
  std::stable_sort(behind.begin(), behind.end(),
                   [](const ReportRow& a, const ReportRow& b) { return numberIn(a, "ratio") > numberIn(b, "ratio"); });
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "'auto' and the best other method at equal cost. The costs are those of the settings of 'auto'; its best setting "
      "within each cost counts. The error of 'auto' is at most " +
      text::figure(maxErrorRatio) + " times the other's at " + std::to_string(within) + " of " +
      std::to_string(points) + " such costs, and at most equal to it at " + std::to_string(best) +
      ". Errors below the noise floor count as the noise floor. In chaotic motion the error is the median of six "
      "starts."});
  TextTable table{"Cloths where 'auto' has a larger error at equal cost",
                  {"cloth", "costs", "larger at", "worst", "its error [m]", "times that of"},
                  {}};
  for (const ReportRow& row : behind) {
    table.rows.push_back(
        {clothOf(row), std::to_string(row.value("points", 0)),
         std::to_string(row.value("points", 0) - row.value("within", 0)), settingText(row), figure(row, "error_mean"),
         figure(row, "ratio", 2) + ": " + row.value("by_method", "") + " " + row.value("by_setting", "")});
  }
  if (!table.rows.empty()) {
    blocks.emplace_back(std::move(table));
  }
  return blocks;
}

}  // namespace drape::report::sections
