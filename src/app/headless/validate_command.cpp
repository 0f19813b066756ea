#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/output_file.hpp"
#include "messages/error.hpp"
#include "report/validation/validation_rows.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace drape::app {
namespace {

struct ValidateArguments {
  std::vector<std::string> cases;
  bool shortForm = false;
  double aim = 0.0;  // [%]; 0: each case's own
  bool markdown = false;
  std::string json;
};

std::vector<report::validation::ValidationCase> validationCasesOf(const ValidateArguments& arguments) {
  std::vector<report::validation::ValidationCase> cases;
  for (const std::string& name : arguments.cases) {
    cases.push_back(report::validation::requireValidationCase(name));
  }
  if (arguments.cases.empty()) {
    const auto all = report::validation::validationTable();
    cases.assign(all.begin(), all.end());
  }
  for (report::validation::ValidationCase& one : cases) {
    one.aim = arguments.aim > 0.0 ? arguments.aim / 100.0 : one.aim;
  }
  return cases;
}

void validate(const ValidateArguments& arguments) {
  const auto cases = validationCasesOf(arguments);
  std::optional<OutputFile> file;
  if (!arguments.json.empty()) {
    file.emplace(arguments.json, "the results");
  }
  std::vector<int> headed;  // the resolutions of the last heading
  report::ReportRows rows;
  std::string off;
  for (const report::validation::ValidationCase& one : cases) {
    const std::span<const int> resolutions = report::validation::resolutionsOf(one, arguments.shortForm);
    if (!arguments.markdown && !std::ranges::equal(resolutions, headed)) {
      std::cout << report::validation::validationHeading(resolutions);
      headed.assign(resolutions.begin(), resolutions.end());
    }
    for (const report::validation::MeshKind kind : kindsOf(one, arguments.shortForm)) {
      const report::validation::ValidationSeries series = report::validation::runValidation(one, kind, resolutions);
      rows.push_back(report::validation::validationRow(series));
      if (!arguments.markdown) {
        std::cout << report::validation::validationLine(rows.back()) << std::flush;
      }
      if (!series.passes()) {
        off += (off.empty() ? "" : ", ") + one.name + " " + std::string(nameOf(kind));
      }
    }
  }
  if (arguments.markdown) {
    std::cout << report::validation::validationMarkdown(rows);
  }
  if (file) {
    file->write(report::ReportRow{{"validation", rows}});
  }
  if (!off.empty()) {
    throw messages::InputError("off by more than the aim: " + off);
  }
}

}  // namespace

void addValidateCommand(CLI::App& app) {
  auto arguments = std::make_shared<ValidateArguments>();
  CLI::App* command =
      app.add_subcommand("validate", "Compares fabric with closed forms and published ranges, with errors and order");
  command->add_option("--only", arguments->cases, "A case's name; may be repeated; default: every case")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--short", arguments->shortForm,
                    "Without the finest resolution, and slow cases with the coarsest one only");
  command
      ->add_option("--aim", arguments->aim,
                   "Largest acceptable error at the finest resolution [%]; default: each case's own")
      ->type_name("PERCENT")
      ->check(numberFrom(1e-6, 100.0));
  command->add_flag("--markdown", arguments->markdown, "Print one table of all results (Markdown)");
  command->add_option("--json", arguments->json, "Write all results to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->footer("Exits with 1 when an error at the finest resolution exceeds its aim.");
  command->callback([arguments] { validate(*arguments); });
}

}  // namespace drape::app
