#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/output_file.hpp"
#include "messages/error.hpp"
#include "report/hardcases/hard_case_rows.hpp"
#include "settings/settings.hpp"
#include "sim/solvers/solver.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>

namespace drape::app {
namespace {

struct HardCasesArguments {
  std::vector<std::string> solvers;
  std::vector<std::string> cases;
  std::vector<std::string> settings;
  bool shortForm = false;
  int starts = 0;
  std::optional<int> start;
  bool markdown = false;
  double maxSeconds = 60.0;
  std::string json;
};

std::vector<std::string> solversOf(const HardCasesArguments& arguments) {
  std::vector<std::string> solvers;
  for (const std::string& name : arguments.solvers) {
    if (name != "all") {
      solvers.push_back(name);
      continue;
    }
    for (const sim::SolverInfo& solver : sim::solverTable()) {
      solvers.emplace_back(solver.name);
    }
  }
  return solvers.empty() ? std::vector<std::string>{settings::Settings().solver.name} : solvers;
}

std::vector<const report::hardcases::HardCase*> casesOf(const HardCasesArguments& arguments) {
  std::vector<const report::hardcases::HardCase*> cases;
  for (const std::string& name : arguments.cases) {
    cases.push_back(&report::hardcases::requireHardCase(name));
  }
  for (const report::hardcases::HardCase& one : report::hardcases::hardCaseTable()) {
    if (arguments.cases.empty()) {
      cases.push_back(&one);
    }
  }
  return cases;
}

/// The starts of a case: 0 is its own, the others are jittered. Only cases of contact have jittered starts.
std::vector<int> startsOf(const HardCasesArguments& arguments, const report::hardcases::HardCase& one) {
  if (!one.contact) {
    return {0};
  }
  if (arguments.start) {
    return {*arguments.start};
  }
  std::vector<int> starts(static_cast<std::size_t>(arguments.starts) + 1);
  std::iota(starts.begin(), starts.end(), 0);
  return starts;
}

/// Runs the cases with one solver. Returns the number of failures.
int runSolver(const HardCasesArguments& arguments, const std::vector<const report::hardcases::HardCase*>& cases,
              const std::string& solver, report::ReportRows& rows) {
  report::hardcases::CaseOptions options;
  options.solver = solver;
  options.shortForm = arguments.shortForm;
  options.settings = arguments.settings;
  options.maxSeconds = arguments.maxSeconds;
  int failed = 0;
  if (!arguments.markdown) {
    std::cout << solver << '\n';
  }
  for (const report::hardcases::HardCase* one : cases) {
    for (const int start : startsOf(arguments, *one)) {
      options.start = start;
      const report::hardcases::CaseResult result = report::hardcases::runHardCase(*one, options);
      const bool isFine = result.outcome == report::hardcases::CaseOutcome::Passed ||
                          result.outcome == report::hardcases::CaseOutcome::Refused;
      failed += isFine ? 0 : 1;
      rows.push_back(report::hardcases::hardCaseRow(*one, options, result));
      if (!arguments.markdown) {
        std::cout << report::hardcases::hardCaseLine(*one, result) << std::flush;
      }
    }
  }
  return failed;
}

void run(const HardCasesArguments& arguments) {
  const auto cases = casesOf(arguments);
  std::optional<OutputFile> file;
  if (!arguments.json.empty()) {
    file.emplace(arguments.json, "the results");
  }
  report::ReportRows rows;
  std::string failures;
  for (const std::string& solver : solversOf(arguments)) {
    const int failed = runSolver(arguments, cases, solver, rows);
    if (failed > 0) {
      failures += (failures.empty() ? "" : ", ") + solver + " " + std::to_string(failed);
    }
  }
  if (arguments.markdown) {
    std::cout << report::hardcases::hardCaseMarkdown(rows);
  }
  if (file) {
    file->write(report::ReportRow{{"hard_cases", rows}});
  }
  if (!failures.empty()) {
    std::size_t runs = 0;
    for (const report::hardcases::HardCase* one : cases) {
      runs += startsOf(arguments, *one).size();
    }
    throw messages::InputError("failed hard cases, of " + std::to_string(runs) + ": " + failures);
  }
}

}  // namespace

void addHardCasesCommand(CLI::App& app) {
  constexpr double longest = 1e5;
  constexpr int maxStarts = 1000;
  auto arguments = std::make_shared<HardCasesArguments>();
  CLI::App* command = app.add_subcommand("hardcases", "Runs cases that are hard for cloth solvers, with pass or fail");
  command->add_option("--solver", arguments->solvers, "A solver's name or 'all'; may be repeated")
      ->type_name("SOLVER")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--case", arguments->cases, "A case's number or name; may be repeated; default: every case")
      ->type_name("N|NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--set", arguments->settings, "Override a setting of the cases; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--short", arguments->shortForm, "Smaller cloths and shorter times");
  CLI::Option* starts =
      command
          ->add_option(
              "--starts", arguments->starts,
              "Run cases of contact from so many jittered starts as well: vertices move by up to 1 % of an edge")
          ->check(numberFrom(0, maxStarts));
  command->add_option("--start", arguments->start, "Run cases of contact from this start only; 0: their own")
      ->type_name("N")
      ->check(numberFrom(0, maxStarts))
      ->excludes(starts);
  command->add_flag("--markdown", arguments->markdown, "Print one table of all solvers (Markdown)");
  command->add_option("--max-seconds", arguments->maxSeconds, "Stop a case that takes longer than this [s]")
      ->check(numberFrom(0.01, longest));
  command->add_option("--json", arguments->json, "Write all results to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->callback([arguments] { run(*arguments); });
}

}  // namespace drape::app
