#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/output_file.hpp"
#include "app/progress_line.hpp"
#include "app/used_files.hpp"
#include "messages/blow_up_text.hpp"
#include "messages/error.hpp"
#include "report/error_table.hpp"
#include "report/measurement.hpp"
#include "report/report_json.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/solver.hpp"

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct MeasureArguments {
  SceneArguments scene;
  double seconds = 0.5;
  std::string against;
  std::vector<std::string> referenceSettings;
  double referenceTolerance = 1e-6;
  bool restarted = false;
  std::vector<double> summaries{0.2, 0.5};
  bool summariesAreGiven = false;  // by the user
  std::string json;
};

/// A minute is far longer than motions can be compared.
constexpr double maxMeasuredSeconds = 60.0;

report::ReferenceKind kindOf(const std::string& against) {
  if (against == "same_step") {
    return report::ReferenceKind::SameStep;
  }
  if (against == "converged") {
    return report::ReferenceKind::Converged;
  }
  if (sim::findSolver(against) != nullptr) {
    return report::ReferenceKind::Solver;
  }
  std::string solvers;
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    solvers += ", " + std::string(solver.name);
  }
  throw messages::UsageError("--against takes same_step, converged or a solver" + solvers + "; '" + against +
                             "' is none of them");
}

/// The settings of the reference: those of its kind, then --reference-set.
settings::Settings referenceSettings(const MeasureArguments& arguments, report::ReferenceKind kind,
                                     const settings::Settings& method) {
  settings::Settings settings = kind == report::ReferenceKind::SameStep    ? report::sameStepSettings(method)
                                : kind == report::ReferenceKind::Converged ? report::convergedSettings(method)
                                                                           : method;
  if (kind == report::ReferenceKind::Solver) {
    settings.solver.name = arguments.against;
  }
  for (const std::string& expression : arguments.referenceSettings) {
    const settings::SettingInfo& info = settings::requireSetting(settings::keyOf(expression));
    if (info.effect != settings::SettingEffect::Step) {
      throw messages::UsageError("--reference-set " + std::string(info.key) +
                                 " would change the cloth; the reference takes settings of the step only");
    }
    settings::assignSettingExpression(settings, expression);
    printFormerKey(expression);
  }
  settings::requireConsistent(settings);
  return settings;
}

/// Shows one progress bar per run, one after the other.
report::Measurement measureWithProgress(const scene::Scene& scene, const report::MeasurementPlan& plan) {
  ProgressLine bars;
  return report::measure(scene, scene.settings, plan,
                         [&bars](std::string_view label, std::int64_t done, std::int64_t total) {
                           bars.show(label, static_cast<double>(done), static_cast<double>(total));
                         });
}

void warn(const report::Measurement& measurement) {
  constexpr double implausible = 2.0;  // cloth does not stretch to three times its length
  if (!measurement.report.checkpoints.empty()) {
    const report::CheckpointReport& last = measurement.report.checkpoints.back();
    if (measurement.own.finite && last.maxStretch > implausible && last.referenceStretch <= implausible) {
      std::cerr << "warning: at the end a spring has " << 1.0 + last.maxStretch
                << " times its rest length: the step is too large for this method\n";
    }
  }
  if (!measurement.reference.doubt.empty()) {
    std::cerr << "warning: " << measurement.reference.doubt << '\n';
  }
}

/// Prints a note about times of --summary after the end.
void noteLateSummaries(const MeasureArguments& arguments, int checkpoints) {
  for (const double time : arguments.summaries) {
    if (std::lround(time / report::checkpointInterval) > checkpoints) {
      std::cerr << "note: there is no summary at " << time << " s, which is after the end; raise --seconds\n";
    }
  }
}

void run(const MeasureArguments& arguments) {
  const report::ReferenceKind kind = kindOf(arguments.against);
  const auto scene = arguments.scene.load();
  report::MeasurementPlan plan;
  plan.checkpoints = report::checkpointsIn(arguments.seconds);
  if (arguments.summariesAreGiven) {
    noteLateSummaries(arguments, plan.checkpoints);
  }
  plan.against = kind;
  plan.reference = referenceSettings(arguments, kind, scene->settings);
  plan.restarted = arguments.restarted;
  plan.tolerance.absolute = arguments.referenceTolerance;
  plan.summaryTimes = arguments.summaries;
  std::optional<OutputFile> file;
  UsedFiles(*scene).write(arguments.json, "--json");
  if (!arguments.json.empty()) {
    file.emplace(arguments.json, "the measurement");
  }
  printSolverWarnings(scene->settings, *scene->model);
  const report::Measurement measurement = measureWithProgress(*scene, plan);
  warn(measurement);
  std::cout << report::errorTable(measurement);
  if (file) {
    file->write(report::measurementJson(measurement));
  }
  if (!measurement.own.finite) {
    throw messages::InputError("the cloth blew up after " + std::to_string(measurement.report.checkpoints.back().time) +
                               " s; the report ends there. " + messages::remedyForBlowUp(*scene->model));
  }
}

}  // namespace

void addMeasureCommand(CLI::App& app) {
  auto arguments = std::make_shared<MeasureArguments>();
  CLI::App* command = app.add_subcommand("measure", "Compares a method with a reference and prints its errors");
  arguments->scene.addTo(*command);
  command->add_option("--seconds", arguments->seconds, "Simulated time [s]; rounded to whole checkpoints of 1/30 s")
      ->required()
      ->check(numberFrom(0.0, maxMeasuredSeconds));
  command
      ->add_option(
          "--against", arguments->against,
          "same_step (this step solved to convergence), converged (the limit of small steps) or a solver's name")
      ->required()
      ->type_name("REFERENCE")
      ->check(notEmpty());
  command->add_flag("--restarted", arguments->restarted, "Start the interval of each checkpoint from the reference");
  command
      ->add_option("--reference-set", arguments->referenceSettings, "Set a setting of the reference; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      ->add_option("--reference-tolerance", arguments->referenceTolerance,
                   "Largest mean change of the converged reference when its step is halved [m]")
      ->check(numberFrom(1e-12, 1.0));
  const CLI::Option* summaries = command->add_option("--summary", arguments->summaries, "Times of the summary [s]")
                                     ->delimiter(',')
                                     ->type_name("T,...")
                                     ->check(numberFrom(0.0, maxMeasuredSeconds));
  command->add_option("--json", arguments->json, "Write all results to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->callback([arguments, summaries] {
    arguments->summariesAreGiven = summaries->count() > 0;
    run(*arguments);
  });
}

}  // namespace drape::app
