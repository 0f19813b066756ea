#include "report/validation/validation_rows.hpp"

#include "report/number_text.hpp"

#include <fmt/core.h>
#include <cmath>

namespace drape::report::validation {
namespace {

double secondsOf(const ValidationSeries& series) {
  double seconds = 0.0;
  for (const ValidationResult& one : series.results) {
    seconds += one.seconds;
  }
  return seconds;
}

}  // namespace

ReportRow validationRow(const ValidationSeries& series) {
  const ValidationCase& one = *series.validationCase;
  ReportRow row{{"name", one.name}, {"title", one.title},          {"compared", one.compared},
                {"unit", one.unit}, {"mesh", nameOf(series.kind)}, {"aim", one.aim}};
  row["exact"] = series.results.empty() ? ReportRow() : finiteOrNull(series.results.back().comparison.exact);
  row["results"] = ReportRow::array();
  for (const ValidationResult& result : series.results) {
    row["results"].push_back({{"resolution", result.resolution},
                              {"measured", finiteOrNull(result.comparison.measured)},
                              {"error", finiteOrNull(result.comparison.error())},
                              {"seconds", result.seconds}});
  }
  row["order"] = finiteOrNull(series.order());
  row["passed"] = series.passes();
  return row;
}

std::string validationLine(const ValidationSeries& series) {
  const ValidationCase& one = *series.validationCase;
  std::string line = fmt::format("{:<20}{:<12}", one.name, nameOf(series.kind));
  for (const ValidationResult& result : series.results) {
    const double error = result.comparison.error();
    line += std::isfinite(error) ? fmt::format("{:>9.3f} %", 100.0 * error) : fmt::format("{:>11}", "none");
  }
  const double order = series.order();
  line += std::isfinite(order) ? fmt::format("{:>8.1f}", order) : fmt::format("{:>8}", "-");
  line += fmt::format("{:>8.1f} %{:>8.2f} s", 100.0 * one.aim, secondsOf(series));
  return line + (series.passes() ? "\n" : "  off\n");
}

std::string validationHeading(std::span<const int> resolutions) {
  std::string line = fmt::format("{:<20}{:<12}", "case", "mesh");
  for (const int resolution : resolutions) {
    line += fmt::format("{:>5} cells", resolution);
  }
  return line + fmt::format("{:>8}{:>10}{:>10}\n", "order", "aim", "time");
}

}  // namespace drape::report::validation
