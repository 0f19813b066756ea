#include "report/hardcases/hard_case_rows.hpp"

#include "report/number_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <map>

namespace drape::report::hardcases {
namespace {

/// The failure in short: "energy gained 35 %".
std::string faultOf(const ReportRow& row) {
  if (row.value("outcome", "") != "failed") {
    return row.value("outcome", "");
  }
  for (const auto& one : row["figures"]) {
    if (!one.value("passes", true)) {
      const std::string unit = one.value("unit", "");
      const std::string value = one["value"].is_number() ? text::figure(one["value"].get<double>(), 2) : "not a number";
      return one.value("name", "") + " " + value + (unit.empty() ? "" : " " + unit);
    }
  }
  const std::string words = row.value("words", "");
  return words.substr(0, words.find('.'));
}

/// The results of a method in a case, from one or more starts.
class CaseCell {
 public:
  void add(const ReportRow& row) {
    const bool fails = row.value("outcome", "") != "passed";
    if (starts_ == 0 || (fails && failures_ == 0)) {
      fault_ = faultOf(row);
    }
    ++starts_;
    failures_ += fails ? 1 : 0;
  }

  [[nodiscard]] std::string text() const {
    return fault_ + (starts_ == 1 || failures_ == 0 ? "" : fmt::format(" ({} of {} starts)", failures_, starts_));
  }

 private:
  std::string fault_;
  int starts_ = 0;
  int failures_ = 0;
};

}  // namespace

ReportRow hardCaseRow(const HardCase& hardCase, const CaseOptions& options, const CaseResult& result) {
  ReportRow row{{"case", hardCase.number},
                {"name", hardCase.name},
                {"method", options.solver},
                {"form", options.shortForm ? "short" : "full"},
                {"start", result.start},
                {"outcome", wordFor(result.outcome)},
                {"passed", result.outcome == CaseOutcome::Passed}};
  row["figures"] = ReportRow::array();
  for (const CaseFigure& one : result.figures) {
    ReportRow found{{"name", one.name}, {"unit", one.unit}, {"value", finiteOrNull(one.value)}};
    if (std::isfinite(one.limit)) {
      found["limit"] = one.limit;
    }
    found["passes"] = one.passes();
    row["figures"].push_back(found);
  }
  row["words"] = result.words;
  row["warning"] = result.warning;
  row["seconds"] = result.seconds;
  return row;
}

std::string figuresInWords(const CaseResult& result) {
  std::string text;
  for (const CaseFigure& one : result.figures) {
    if (one.name != "max distance" || !one.passes()) {
      text += (text.empty() ? "" : ", ") + one.text();
    }
  }
  return text;
}

std::string warningInWords(const std::string& warning) {
  return warning.empty() ? "" : "The solver warned: " + warning;
}

std::string hardCaseLine(const HardCase& hardCase, const CaseResult& result) {
  const std::string name =
      std::string(hardCase.name) + (result.start > 0 ? fmt::format(", start {}", result.start) : "");
  const std::string start =
      fmt::format("{:>2}  {:<30}{:<9}{:>8.2f} s  ", hardCase.number, name, wordFor(result.outcome), result.seconds);
  const std::string figures = figuresInWords(result);
  const bool ended = result.outcome == CaseOutcome::GivenUp || result.outcome == CaseOutcome::Refused ||
                     result.words.starts_with("The state was no longer finite");
  const std::string warning = result.warning.empty() ? "" : "    " + warningInWords(result.warning) + "\n";
  return start + (ended ? result.words : figures) + "\n" + warning;
}

std::string hardCaseMarkdown(const ReportRows& rows) {
  std::vector<std::string> methods;
  std::map<int, std::map<std::string, CaseCell>> cells;
  for (const ReportRow& row : rows) {
    const std::string method = row.value("method", "");
    if (std::find(methods.begin(), methods.end(), method) == methods.end()) {
      methods.push_back(method);
    }
    cells[row.value("case", 0)][method].add(row);
  }
  std::string text = "| case |";
  std::string line = "|---|";
  for (const std::string& method : methods) {
    text += " " + method + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const auto& [number, own] : cells) {
    text += "| " + std::to_string(number) + " " + std::string(requireHardCase(std::to_string(number)).name) + " |";
    for (const std::string& method : methods) {
      const auto found = own.find(method);
      text += " " + (found == own.end() ? "" : found->second.text()) + " |";
    }
    text += "\n";
  }
  return text;
}

std::string hardCaseListMarkdown() {
  std::string text = "| | case | description | criterion |\n|---|---|---|---|\n";
  for (const HardCase& one : hardCaseTable()) {
    text += "| " + std::to_string(one.number) + " | `" + std::string(one.name) + "` | " + std::string(one.statement) +
            " | " + std::string(one.rule) + " |\n";
  }
  return text;
}

}  // namespace drape::report::hardcases
