#include "report/number_text.hpp"
#include "report/sections/budget_choice.hpp"
#include "report/sections/paper_claims.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape::report::sections {
namespace {

/// A kind of cloth of the answer, and the cloth of the report that stands for it.
struct Kind {
  std::string_view name;
  std::string_view section;   ///< whose rows have its errors
  std::string_view scene;     ///< in that section
  std::string_view material;  ///< "springs", or the preset of a fabric; empty: any
  double stiffness = 0.0;     ///< of springs [N/m]
};

constexpr std::array kinds{Kind{"Soft sheet", "work_precision", "hang", "springs", 10.0},
                           Kind{"Stiff sheet", "work_precision", "hang", "springs", 1e5},
                           Kind{"Garment in cotton", "work_precision", "tshirt", "cotton"},
                           Kind{"Garment on a body", "budget", "mannequin", ""},
                           Kind{"Flag in wind", "work_precision", "flag", "springs", 1000.0}};

/// The largest grid that counts, so that all sheets have about as many vertices as a garment.
constexpr int largestGrid = 33;

bool isOfKind(const Kind& kind, const ReportRow& row) {
  if (row.value("scene", "") != kind.scene || row.value("kind", "") == "own") {
    return false;
  }
  return kind.material.empty() || (row.value("material", "") == kind.material && resolutionIn(row) <= largestGrid &&
                                   (kind.material != "springs" || numberIn(row, "stiffness") == kind.stiffness));
}

bool hasErrors(const ReportRows& rows) {
  return std::any_of(rows.begin(), rows.end(), isCalmRow);
}

/// The rows of a kind at the largest resolution, at the latest time with known errors; empty when there are none.
ReportRows rowsOfKind(const Kind& kind, const SectionRows& all) {
  const auto section = all.find(kind.section);
  if (section == all.end()) {
    return {};
  }
  std::map<std::pair<int, double>, ReportRows> candidates;
  for (const ReportRow& row : section->second) {
    if (isOfKind(kind, row)) {
      candidates[{resolutionIn(row), numberIn(row, "time")}].push_back(row);
    }
  }
  const auto found = std::find_if(candidates.rbegin(), candidates.rend(),
                                  [](const auto& candidate) { return hasErrors(candidate.second); });
  return found != candidates.rend() ? found->second : candidates.empty() ? ReportRows() : candidates.rbegin()->second;
}

std::string clothText(const Kind& kind, const ReportRow& row) {
  return kind.section == "budget"
             ? row.value("scene", "") + ", " + figure(row, "vertices", 7) + " vertices, " + figure(row, "time") + " s"
             : clothOf(row);
}

/// Writes a setting with its cost and its error under these keys.
void writeSetting(const ReportRow* setting, const std::string& key, ReportRow& row) {
  row[key] = setting == nullptr ? ReportRow(nullptr) : ReportRow(takeText(*setting));
  row[key + "_ms"] =
      setting == nullptr ? ReportRow(nullptr) : ReportRow(msPerFrame(numberIn(*setting, "us_per_simulated_second")));
  row[key + "_error"] = setting == nullptr ? ReportRow(nullptr) : (*setting)["error_mean"];
}

ReportRow answerOf(const Kind& kind, const ReportRows& rows, double budget) {
  ReportRow row{{"question", "method"}, {"kind", kind.name}, {"cloth", nullptr},
                {"budget_ms", budget},  {"method", nullptr}, {"setting", nullptr},
                {"cost_ms", nullptr},   {"error", nullptr},  {"error_floor", nullptr}};
  writeSetting(rows.empty() ? nullptr : cheapestCalm(rows), "cheapest", row);
  writeSetting(rows.empty() ? nullptr : bestForBudget(rows, std::numeric_limits<double>::infinity()), "finest", row);
  if (rows.empty()) {
    return row;
  }
  row["cloth"] = clothText(kind, rows.front());
  row["error_floor"] = finiteOrNull(errorFloor(rows));
  if (const ReportRow* best = bestForBudget(rows, budget)) {
    row["method"] = (*best)["method"];
    row["setting"] = (*best)["setting"];
    row["cost_ms"] = msPerFrame(numberIn(*best, "us_per_simulated_second"));
    row["error"] = (*best)["error_mean"];
  }
  return row;
}

ReportRows derive(const SectionRows& all) {
  ReportRows answers;
  bool any = false;
  for (const Kind& kind : kinds) {
    const ReportRows rows = rowsOfKind(kind, all);
    any = any || !rows.empty();
    for (const double budget : frameBudgets()) {
      answers.push_back(answerOf(kind, rows, budget));
    }
  }
  for (ReportRow& row : claimRows(all)) {
    const std::string verdict = row.value("verdict", "");
    any = any || verdict == confirmed || verdict == refuted;
    answers.push_back(std::move(row));
  }
  return any ? answers : ReportRows();
}

/// "0.17 ms, off by 3 mm".
std::string costAndErrorText(const ReportRow& row, const char* cost, const char* error) {
  return figure(row, cost) + " ms, off by " + errorText({{"error_mean", row[error]}}, numberIn(row, "error_floor"));
}

/// The setting under this key, with its cost and its error.
std::string settingText(const ReportRow& row, const std::string& key) {
  return row.value(key, "") + ": " + costAndErrorText(row, (key + "_ms").c_str(), (key + "_error").c_str());
}

/// @param isLargest whether it is the largest budget: the field then tells what exceeds it
std::string fieldOf(const ReportRow& row, bool isLargest) {
  if (row["cloth"].is_null()) {
    return "not measured";
  }
  if (!row["method"].is_null()) {
    return row.value("method", "") + " " + row.value("setting", "") + "\n" + costAndErrorText(row, "cost_ms", "error");
  }
  if (row["cheapest"].is_null()) {
    return "no known error";
  }
  if (!isLargest) {
    return "none";
  }
  const bool oneDoesBoth = row["cheapest"] == row["finest"];
  return "none\nThe cheapest is " + settingText(row, "cheapest") +
         (oneDoesBoth ? "" : "\nThe smallest error has " + settingText(row, "finest"));
}

/// Whether the methods for a kind of cloth were measured.
bool hasMethods(const ReportRow& row) {
  return row.value("question", "") == "method" && !row["cloth"].is_null();
}

bool isTestedClaim(const ReportRow& row) {
  return row.value("question", "") == "claim" && row.value("verdict", "") != notMeasured;
}

TextTable methodTable(const ReportRows& rows) {
  TextTable table{"The method to take: its settings, its cost per frame, and its error", {"cloth"}, {}};
  for (const double budget : frameBudgets()) {
    table.header.push_back(text::figure(budget) + " ms a frame");
  }
  table.header.back() += " (real time)";
  std::string last;
  for (const ReportRow& row : rows) {
    if (row.value("question", "") != "method") {
      continue;
    }
    if (row.value("kind", "") != last) {
      last = row.value("kind", "");
      table.rows.push_back({last + (row["cloth"].is_null() ? "" : "\n" + row.value("cloth", ""))});
    }
    table.rows.back().push_back(fieldOf(row, numberIn(row, "budget_ms") == frameBudgets().back()));
  }
  return table;
}

TextTable claimTable(const ReportRows& rows) {
  TextTable table{"The paper's claims", {"claim", "verdict", "measured in this run"}, {}};
  for (const ReportRow& row : rows) {
    if (row.value("question", "") == "claim") {
      table.rows.push_back({row.value("claim", ""), row.value("verdict", ""), row.value("figure", "")});
      table.tones.push_back(row.value("verdict", "") == refuted ? Tone::Bad : Tone::None);
    }
  }
  return table;
}

std::vector<Block> show(const ReportOptions&, const ReportRows& rows) {
  std::vector<Block> blocks;
  if (std::ranges::any_of(rows, hasMethods)) {
    blocks.emplace_back(methodTable(rows));
    blocks.emplace_back(
        Paragraph{"Of all settings that this run measured, the one with the smallest error within the budget. The "
                  "error is the mean distance of the vertices from the converged motion at the time in the first "
                  "column; \"less than\" marks the distance below which errors cannot be told apart. A frame is 1/60 "
                  "s; costs are of one thread, with contact on the body and without it elsewhere."});
  }
  if (std::ranges::any_of(rows, isTestedClaim)) {
    blocks.emplace_back(claimTable(rows));
  }
  return blocks;
}

}  // namespace

Section answer() {
  return {"answer", "The answer", nullptr, show, derive};
}

}  // namespace drape::report::sections
