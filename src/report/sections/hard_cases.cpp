#include "report/hardcases/hard_case_rows.hpp"
#include "report/sections/sections.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace drape::report::sections {
namespace {

/// The full form of all cases takes minutes per method. In a report only `auto`, which must pass all cases, gets it.
/// `drape-headless hardcases` runs it for every method.
bool isShort(const std::string& method, const ReportOptions& options) {
  return options.quick || method != "auto";
}

/// Time limit of a method for a case [s]. Tests check the results of a quick report, so these must not depend on the
/// load of the machine. Cases of contact take longer.
double maxSeconds(const hardcases::HardCase& one, bool shortForm, const ReportOptions& options) {
  const double factor = one.contact ? 10.0 : 1.0;
  if (!shortForm) {
    return factor * 30.0;
  }
  return factor * (options.quick ? 2.0 : 1.0);
}

ReportRows measureCase(const hardcases::HardCase& one, const std::string& method, const ReportOptions& options,
                       const CellContext& context) {
  hardcases::CaseOptions asked;
  asked.solver = method;
  asked.shortForm = isShort(method, options);
  // More iterations take too long in any case.
  asked.settings = {"threads=" + std::to_string(options.threads), "max_iterations=100"};
  asked.maxSeconds = maxSeconds(one, asked.shortForm, options);
  asked.checkStop = context.checkStop;
  return {hardcases::hardCaseRow(one, asked, hardcases::runHardCase(one, asked))};
}

/// The methods of a quick report: the paper's and `auto`.
std::vector<std::string> methodsFor(const ReportOptions& options) {
  std::vector<std::string> methods;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    if (!options.quick || solver.name == "one_iteration" || solver.name == "auto") {
      methods.emplace_back(solver.name);
    }
  }
  return methods;
}

SectionPlan plan(const ReportOptions& options) {
  SectionPlan plan;
  for (const hardcases::HardCase& one : hardcases::hardCaseTable()) {
    for (const std::string& method : methodsFor(options)) {
      plan.cells.push_back({method + " " + std::to_string(one.number) + " " + std::string(one.name),
                            isShort(method, options) ? 0.3 : 5.0, [&one, method, options](const CellContext& context) {
                              return measureCase(one, method, options, context);
                            }});
    }
  }
  return plan;
}

const std::vector<MapState>& states() {
  static const std::vector<MapState> all{{"passed", "P", Tone::Good},
                                         {"failed", "F", Tone::Bad},
                                         {"given up", "-", Tone::None},
                                         {"refused", "x", Tone::Dull},
                                         {"not measured", "", Tone::None}};
  return all;
}

int indexOf(const std::string& outcome) {
  const auto found =
      std::find_if(states().begin(), states().end(), [&](const MapState& known) { return known.name == outcome; });
  return static_cast<int>(std::min<std::ptrdiff_t>(found - states().begin(), std::ssize(states()) - 1));
}

using RowOf = std::map<std::pair<int, std::string>, const ReportRow*>;

std::vector<std::string> methodsIn(const ReportRows& rows) {
  std::vector<std::string> methods;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    const auto isIts = [&](const ReportRow& row) { return row.value("method", "") == solver.name; };
    if (std::any_of(rows.begin(), rows.end(), isIts)) {
      methods.emplace_back(solver.name);
    }
  }
  return methods;
}

StateMap mapOf(const RowOf& rows, const std::vector<std::string>& methods) {
  StateMap map{"hard-cases", "Cases that each method passes", "case", {}, {}, states()};
  for (const hardcases::HardCase& one : hardcases::hardCaseTable()) {
    map.columns.push_back(std::to_string(one.number));
  }
  for (const std::string& method : methods) {
    StateMap::Row line{method, {}};
    for (const hardcases::HardCase& one : hardcases::hardCaseTable()) {
      const auto found = rows.find({one.number, method});
      line.cells.push_back(indexOf(found == rows.end() ? "" : found->second->value("outcome", "")));
    }
    map.rows.push_back(line);
  }
  return map;
}

/// The failures of each method, by case.
TextTable faultsOf(const RowOf& rows, const std::vector<std::string>& methods) {
  TextTable table{"Failures", {"method", "case", "outcome", "figures"}, {}};
  for (const std::string& method : methods) {
    for (const hardcases::HardCase& one : hardcases::hardCaseTable()) {
      const auto found = rows.find({one.number, method});
      if (found != rows.end() && !found->second->value("passed", false) &&
          found->second->value("outcome", "") != "refused") {
        const std::string warning = hardcases::warningInWords(found->second->value("warning", ""));
        table.rows.push_back({method, std::to_string(one.number) + " " + std::string(one.name),
                              found->second->value("outcome", ""),
                              found->second->value("words", "") + (warning.empty() ? "" : ". " + warning)});
      }
    }
  }
  return table;
}

TextTable casesAsTable() {
  TextTable table{"The cases", {"case", "description", "criterion"}, {}};
  for (const hardcases::HardCase& one : hardcases::hardCaseTable()) {
    table.rows.push_back(
        {std::to_string(one.number) + " " + std::string(one.name), std::string(one.statement), std::string(one.rule)});
  }
  return table;
}

std::vector<Block> show(const ReportOptions& options, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  RowOf cells;
  for (const ReportRow& row : rows) {
    cells[{row.value("case", 0), row.value("method", "")}] = &row;
  }
  const auto methods = methodsIn(rows);
  std::vector<Block> blocks;
  blocks.emplace_back(
      Paragraph{std::string("Cases that are hard for cloth solvers (docs/guide/hardcases.md), in their short form") +
                (options.quick ? "" : ", for 'auto' in the full form") +
                ". Every method has its default settings; the explicit methods use as many substeps as half of "
                "their stability limit needs. In every case the state must stay finite, no vertex may move beyond 1e5 "
                "m, and the energy "
                "may rise by at most 1 % of the scene's scale beyond external work. Given up: it took too long. "
                "Refused: the case has a fabric, and the solver takes springs only."});
  blocks.emplace_back(mapOf(cells, methods));
  blocks.emplace_back(casesAsTable());
  blocks.emplace_back(faultsOf(cells, methods));
  return blocks;
}

}  // namespace

Section hardCases() {
  return {"hard_cases", "Hard cases", plan, show};
}

}  // namespace drape::report::sections
