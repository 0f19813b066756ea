#include "report/number_text.hpp"
#include "report/sections/equal_cost.hpp"
#include "report/sections/sections.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

namespace drape::report::sections {
namespace {

/// Error limits as shares of the cloth's diagonal [-].
constexpr std::array shares{1e-2, 1e-3, 1e-4};
/// The time budget of a frame, one millisecond, per simulated second [us].
constexpr double budgetOfSecond = 1000.0 / frameSeconds;

ReportRow rowFor(const ReportRow& like, const char* question) {
  ReportRow row;
  for (const char* key : {"scene", "resolution", "material", "stiffness", "time"}) {
    row[key] = like.value(key, ReportRow());
  }
  row["question"] = question;
  return row;
}

void answer(ReportRow& row, const ReportRow* by) {
  for (const char* key : {"method", "setting", "us_per_simulated_second", "error_mean", "error_of_diagonal"}) {
    row[key] = by == nullptr ? ReportRow(nullptr) : (*by)[key];
  }
}

/// The cheapest row of a cloth with at most that error; null when there is none.
const ReportRow* cheapest(const ReportRows& rows, double share) {
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    const bool fits = isCalmRow(row) && numberIn(row, "error_of_diagonal") < share;
    if (fits &&
        (best == nullptr || numberIn(row, "us_per_simulated_second") < numberIn(*best, "us_per_simulated_second"))) {
      best = &row;
    }
  }
  return best;
}

/// The row of a cloth and method with the smallest error within the budget; null when there is none.
const ReportRow* bestWithin(const ReportRows& rows, const std::string& method) {
  const ReportRow* best = nullptr;
  for (const ReportRow& row : rows) {
    const bool fits = isCalmRow(row) && row.value("method", "") == method &&
                      numberIn(row, "us_per_simulated_second") <= budgetOfSecond;
    if (fits && (best == nullptr || numberIn(row, "error_of_diagonal") < numberIn(*best, "error_of_diagonal"))) {
      best = &row;
    }
  }
  return best;
}

std::vector<std::string> methodsIn(const ReportRows& rows) {
  std::vector<std::string> methods;
  for (const ReportRow& row : rows) {
    const std::string method = row.value("method", "");
    if (std::find(methods.begin(), methods.end(), method) == methods.end()) {
      methods.push_back(method);
    }
  }
  return methods;
}

ReportRows derive(const SectionRows& all) {
  const auto found = all.find("work_precision");
  std::map<WorkClothAt, ReportRows> setups;
  for (const ReportRow& row : found == all.end() ? ReportRows() : found->second) {
    setups[workClothAt(row)].push_back(row);
  }
  ReportRows answers;
  for (const auto& [setup, rows] : setups) {
    for (const double share : shares) {
      ReportRow row = rowFor(rows.front(), "cheapest");
      row["share"] = share;
      answer(row, cheapest(rows, share));
      answers.push_back(row);
    }
    for (const std::string& method : methodsIn(rows)) {
      ReportRow row = rowFor(rows.front(), "budget");
      answer(row, bestWithin(rows, method));
      row["method"] = method;
      answers.push_back(row);
    }
    answers.push_back(equalCostRow(rows, rowFor(rows.front(), "equal_cost")));
  }
  return answers;
}

std::string cheapestText(const ReportRow& row) {
  if (row["setting"].is_null()) {
    return "none";
  }
  return row.value("method", "") + " " + row.value("setting", "") + " (" + frameCost(row) + " ms)";
}

TextTable cheapestTable(const ReportRows& rows) {
  TextTable table{
      "Cheapest setting, with its time per frame", {"cloth", "error under 1 %", "under 0.1 %", "under 0.01 %"}, {}};
  for (const ReportRow& row : rows) {
    if (row.value("question", "") == "cheapest") {
      if (numberIn(row, "share") == shares.front()) {
        table.rows.push_back({clothOf(row)});
      }
      table.rows.back().push_back(cheapestText(row));
    }
  }
  return table;
}

/// A row per cloth, a column per method.
TextTable budgetTable(const ReportRows& rows) {
  ReportRows asked;
  for (const ReportRow& row : rows) {
    if (row.value("question", "") == "budget") {
      asked.push_back(row);
    }
  }
  const std::vector<std::string> methods = methodsIn(asked);
  TextTable table{"Smallest error for 1 ms per frame [% of the diagonal]", {"cloth"}, {}};
  table.header.insert(table.header.end(), methods.begin(), methods.end());
  std::map<WorkClothAt, std::map<std::string, std::string>> errors;
  std::map<WorkClothAt, std::string> names;
  for (const ReportRow& row : asked) {
    constexpr double percent = 100.0;
    errors[workClothAt(row)][row.value("method", "")] = text::figure(percent * numberIn(row, "error_of_diagonal"), 2);
    names[workClothAt(row)] = clothOf(row);
  }
  for (auto& [setup, own] : errors) {
    table.rows.push_back({names[setup]});
    for (const std::string& method : methods) {
      table.rows.back().push_back(own[method]);
    }
  }
  return table;
}

/// How often each method is the cheapest at one of the error limits.
std::string winnersText(const ReportRows& rows) {
  std::map<std::string, int> wins;
  int asked = 0;
  for (const ReportRow& row : rows) {
    if (row.value("question", "") == "cheapest") {
      ++asked;
      wins[row["method"].is_null() ? "none" : row.value("method", "")] += 1;
    }
  }
  std::string text = "Of these " + std::to_string(asked) + " places";
  for (const auto& [method, count] : wins) {
    text += (method == wins.begin()->first ? " " : ", ") + std::to_string(count) + " go to " + method;
  }
  return text + ".";
}

std::vector<Block> show(const ReportOptions&, const ReportRows& rows) {
  std::vector<Block> blocks;
  blocks.emplace_back(
      Paragraph{"Computed from the previous section, from its calm settings. Errors are mean distances from the "
                "converged motion at that time, as a share of the cloth's diagonal. A frame is 1/60 s."});
  blocks.emplace_back(cheapestTable(rows));
  blocks.emplace_back(Paragraph{winnersText(rows)});
  blocks.emplace_back(budgetTable(rows));
  ReportRows atEqualCost;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(atEqualCost),
               [](const ReportRow& row) { return row.value("question", "") == "equal_cost"; });
  for (Block& block : equalCostBlocks(atEqualCost)) {
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace

Section conclusions() {
  return {"conclusions", "Conclusions", nullptr, show, derive};
}

}  // namespace drape::report::sections
