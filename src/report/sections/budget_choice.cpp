#include "report/sections/budget_choice.hpp"

#include "report/number_text.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace drape::report::sections {
namespace {

double costOf(const ReportRow& row) {
  return msPerFrame(numberIn(row, "us_per_simulated_second"));
}

}  // namespace

std::vector<double> frameBudgets() {
  return {0.1, 0.5, 2.0, 8.0, 1000.0 * frameSeconds};
}

double errorFloor(const ReportRows& rows) {
  double floor = std::numeric_limits<double>::quiet_NaN();
  for (const ReportRow& row : rows) {
    for (const char* key : {"noise_floor", "reference_difference"}) {
      floor = std::fmax(floor, numberIn(row, key));
    }
  }
  return floor;
}

const ReportRow* bestForBudget(const ReportRows& rows, double budget) {
  const double floor = errorFloor(rows);
  const auto rank = [&](const ReportRow& row) {
    return std::tuple(std::fmax(floor, numberIn(row, "error_mean")), costOf(row));
  };
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    if (isCalmRow(row) && costOf(row) <= budget && (best == nullptr || rank(row) < rank(*best))) {
      best = &row;
    }
  }
  return best;
}

const ReportRow* cheapestCalm(const ReportRows& rows) {
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    if (isCalmRow(row) && (best == nullptr || costOf(row) < costOf(*best))) {
      best = &row;
    }
  }
  return best;
}

std::string distanceText(double metres) {
  constexpr double finest = 1e-6;  // smaller distances are of no interest [m]
  return metres < finest ? "less than 1 um" : text::formatLength(metres);
}

std::string errorText(const ReportRow& row, double floor) {
  const double error = numberIn(row, "error_mean");
  constexpr double finest = 1e-6;
  return error <= floor ? "less than " + text::formatLength(std::max(floor, finest)) : distanceText(error);
}

std::string takeText(const ReportRow& row) {
  return row.value("method", "") + " " + row.value("setting", "");
}

}  // namespace drape::report::sections
