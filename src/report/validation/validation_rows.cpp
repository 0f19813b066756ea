#include "report/validation/validation_rows.hpp"

#include "report/number_text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <cmath>

namespace drape::report::validation {
namespace {

bool isRange(const ReportRow& row) {
  return row.contains("upper") && row["upper"].is_number();
}

std::string percent(double share, int digits) {
  const std::string text = fmt::format("{:.{}f} %", 100.0 * share, digits);
  const bool isZero = text.find_first_not_of("-0. %") == std::string::npos;
  return isZero && text.starts_with('-') ? text.substr(1) : text;
}

/// A shape, with its positions in tenths of a millimetre.
ReportRow rowOf(const DrapedShape& shape) {
  constexpr double unitsOfMetre = 1e4;
  ReportRow row{{"positions", ReportRow::array()}, {"triangles", ReportRow::array()}};
  for (const Vec3& position : shape.positions) {
    for (const double coordinate : position) {
      row["positions"].push_back(std::lround(unitsOfMetre * coordinate));
    }
  }
  for (const Triangle& triangle : shape.triangles) {
    for (const int corner : triangle) {
      row["triangles"].push_back(corner);
    }
  }
  return row;
}

/// Errors of all resolutions, separated by commas.
std::string figuresOf(const ReportRow& row) {
  std::string text;
  for (const ReportRow& result : row["results"]) {
    text += (text.empty() ? "" : ", ") + figureOf(row, result);
  }
  return text;
}

}  // namespace

ReportRow validationRow(const ValidationSeries& series) {
  const ValidationCase& one = *series.validationCase;
  ReportRow row{{"group", nameOf(one.group)},
                {"name", one.name},
                {"title", one.title},
                {"compared", one.compared},
                {"unit", one.unit},
                {"mesh", nameOf(series.kind)},
                {"aim", one.aim}};
  const Comparison last = series.results.empty() ? Comparison() : series.results.back().comparison;
  row["exact"] = series.results.empty() ? ReportRow() : finiteOrNull(last.exact);
  row["upper"] = finiteOrNull(last.upper);
  row["results"] = ReportRow::array();
  for (const ValidationResult& result : series.results) {
    row["results"].push_back({{"resolution", result.resolution},
                              {"measured", finiteOrNull(result.comparison.measured)},
                              {"error", finiteOrNull(result.comparison.error())},
                              {"seconds", result.seconds},
                              {"note", result.comparison.note}});
    if (result.comparison.shape != nullptr) {
      row["shape"] = rowOf(*result.comparison.shape);
    }
  }
  row["order"] = finiteOrNull(series.order());
  row["passed"] = series.passes();
  row["reason"] = one.reason;
  return row;
}

std::string figureOf(const ReportRow& row, const ReportRow& result) {
  if (!result["error"].is_number()) {
    return "none";
  }
  return isRange(row) ? fmt::format("{:.1f}", result.value("measured", 0.0)) : percent(result.value("error", 0.0), 3);
}

std::string cellsOf(const ReportRow& row) {
  std::string text;
  for (const ReportRow& result : row["results"]) {
    text += (text.empty() ? "" : ", ") + std::to_string(result.value("resolution", 0));
  }
  return text;
}

std::string aimOf(const ReportRow& row) {
  return isRange(row) ? fmt::format("{:.3g} to {:.3g}", row.value("exact", 0.0), row.value("upper", 0.0))
                      : percent(row.value("aim", 0.0), 1);
}

std::string orderOf(const ReportRow& row) {
  return row["order"].is_number() ? fmt::format("{:.1f}", row.value("order", 0.0)) : "-";
}

double secondsOf(const ReportRow& row) {
  double seconds = 0.0;
  for (const ReportRow& one : row["results"]) {
    seconds += one.value("seconds", 0.0);
  }
  return seconds;
}

std::string validationLine(const ReportRow& row) {
  std::string line = fmt::format("{:<26}{:<12}", row.value("name", ""), row.value("mesh", ""));
  for (const ReportRow& result : row["results"]) {
    line += fmt::format("{:>11}", figureOf(row, result));
  }
  line += fmt::format("{:>8}{:>10}{:>8.2f} s", orderOf(row), aimOf(row), secondsOf(row));
  return line + (row.value("passed", false) ? "\n" : "  off\n");
}

std::string validationHeading(std::span<const int> resolutions) {
  std::string line = fmt::format("{:<26}{:<12}", "case", "mesh");
  for (const int resolution : resolutions) {
    line += fmt::format("{:>5} cells", resolution);
  }
  return line + fmt::format("{:>8}{:>10}{:>10}\n", "order", "aim", "time");
}

std::string validationListMarkdown() {
  std::string text = "| case | test | quantity | cells | aim |\n|---|---|---|---|---:|\n";
  for (const ValidationCase& one : validationTable()) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", one.name, one.title, one.compared,
                        fmt::join(one.resolutions, ", "), percent(one.aim, 1));
  }
  return text;
}

std::string validationMarkdown(const ReportRows& rows) {
  std::string text = "| case | mesh | cells | error | order | aim | result |\n|---|---|---:|---:|---:|---:|---|\n";
  for (const ReportRow& row : rows) {
    const bool passed = row.value("passed", false);
    const std::string mark = passed ? "" : "**";
    text += fmt::format("| `{}` | {} | {} | {}{}{} | {} | {} | {}{}{} |\n", row.value("name", ""),
                        row.value("mesh", ""), cellsOf(row), mark, figuresOf(row), mark, orderOf(row), aimOf(row), mark,
                        passed ? "within" : "off", mark);
  }
  return text;
}

}  // namespace drape::report::validation
