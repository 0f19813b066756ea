#include "app/command_line.hpp"
#include "app/progress_line.hpp"
#include "app/report/report_folder.hpp"
#include "app/report/stop_signal.hpp"
#include "build_info.hpp"
#include "messages/error.hpp"
#include "report/comparison.hpp"
#include "report/machine.hpp"
#include "report/plain_text.hpp"
#include "report/sections/set_ups.hpp"
#include "report/trajectory.hpp"

#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drape::app {
namespace {

/// After this time nothing is measured a second time, so that a full report ends in about an hour and a quick one
/// within 90 s [s].
constexpr double repeatTimeOfFull = 45.0 * 60.0;
constexpr double repeatTimeOfQuick = 60.0;

struct ReportArguments {
  report::ReportOptions options{.quick = false, .scene = {}, .threads = 1, .only = {}};
  std::string output;
  std::string compare;
  bool resume = false;
  SceneArguments own;  ///< --scene and --set, with a budget
  std::optional<double> budget;
  std::optional<double> seconds;
};

/// The options for one's own cloth.
void addBudgetOptions(CLI::App& app, ReportArguments& arguments) {
  constexpr double minBudget = 0.01;
  constexpr double maxBudget = 1000.0;
  constexpr double minSeconds = 0.034;  // one checkpoint
  constexpr double maxSeconds = 10.0;
  app.add_option("--budget", arguments.budget,
                 "Find the method for the cloth of --scene, with its contact, that has the smallest error for this "
                 "computing time per frame of 1/60 s [ms]")
      ->type_name("MS")
      ->check(numberFrom(minBudget, maxBudget));
  app.add_option("--set", arguments.own.settings,
                 "With --budget: set a setting; may be repeated ('drape-headless list settings' lists them)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  app.add_option("--seconds", arguments.seconds, "With --budget: the motion at whose end errors count [s] (0.5)")
      ->check(numberFrom(minSeconds, maxSeconds));
  addFabricsOption(app, arguments.own.fabrics);
}

void addTo(CLI::App& app, ReportArguments& arguments) {
  constexpr int maxThreads = 64;
  std::string sections;
  for (const report::Section& section : report::sectionTable()) {
    if (section.plan != nullptr) {
      sections += sections.empty() ? "" : ", ";
      sections += section.name;
    }
  }
  app.add_flag("--quick", arguments.options.quick, "Fewer and smaller measurements: a few minutes");
  app.add_option("--only", arguments.options.only, "Measure only this section (" + sections + "); may be repeated")
      ->type_name("SECTION")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  app.add_option(
         "--scene", arguments.options.scene,
         "Compare methods on this scene only: hang, flag, crush, twist, tshirt, tshirt_of_springs, four_corners, "
         "one_corner, one_edge or any scene with a grid; with --budget any scene, scene file or mesh file")
      ->type_name("SCENE|MESH")
      ->check(notEmpty());
  app.add_option("--threads", arguments.options.threads,
                 "Threads of a step in measurements that do not compare methods (1)")
      ->check(CLI::Range(1, maxThreads));
  app.add_flag("--resume", arguments.resume, "Continue the report.json in the folder");
  app.add_option("--compare", arguments.compare,
                 "List changes beyond noise since this earlier report.json; exit status 3 when there are any")
      ->type_name("OLD.json")
      ->check(notEmpty());
  app.add_option("--output", arguments.output,
                 "Folder for report.html, report.md and report.json; required without --budget")
      ->type_name("DIR")
      ->check(notEmpty());
  addBudgetOptions(app, arguments);
}

/// Saves the measurements every few seconds, since the program may be killed.
class ReportSaver {
 public:
  /// @param folder empty: nothing is saved
  ReportSaver(const std::optional<ReportFolder>& folder, report::Report& report) : folder_(folder), report_(report) {}

  void save() {
    constexpr std::chrono::seconds pause(5);
    if (folder_ && std::chrono::steady_clock::now() - last_ > pause) {
      folder_->writeJson(report_);
      last_ = std::chrono::steady_clock::now();
    }
  }

 private:
  const std::optional<ReportFolder>& folder_;
  report::Report& report_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Throws UsageError for options that do not go together.
void requireConsistent(const ReportArguments& arguments) {
  const bool hasBudget = arguments.budget.has_value();
  if (hasBudget && arguments.options.scene.empty()) {
    throw messages::UsageError("--budget needs --scene with the scene or the mesh file of the cloth");
  }
  if (hasBudget && !arguments.options.only.empty()) {
    throw messages::UsageError("--only does not go with --budget, which measures the cloth of --scene alone");
  }
  if (!hasBudget && (!arguments.own.settings.empty() || arguments.seconds || !arguments.own.fabrics.empty())) {
    throw messages::UsageError("--set, --seconds and --fabrics need --budget");
  }
  if (!arguments.output.empty()) {
    return;
  }
  if (!hasBudget || arguments.resume || !arguments.compare.empty()) {
    throw messages::UsageError("--output is required: the folder for report.html, report.md and report.json");
  }
}

/// The options of the report, with the cloth of --budget. Throws as SceneArguments::load does.
report::ReportOptions optionsOf(const ReportArguments& arguments) {
  constexpr double usualSeconds = 0.5;
  report::ReportOptions options = arguments.options;
  if (!arguments.budget) {
    (void)report::sections::comparedSetUps(options.scene);  // reports wrong names before the measurements
    return options;
  }
  SceneArguments own = arguments.own;
  own.scene = options.scene;
  options.own = report::OwnCloth{own.load(), own.settings, *arguments.budget, arguments.seconds.value_or(usualSeconds)};
  (void)report::stepsPerCheckpoint(options.own->scene->settings.step.timeStep);
  options.only = {std::string(report::budgetSection)};
  return options;
}

report::Report emptyReport(report::ReportOptions options) {
  report::Report report;
  report.machine = report::machineJson(report::buildInfo());
  report.options = std::move(options);
  return report;
}

/// Takes the measurements that the folder has.
void resume(const ReportFolder& folder, report::Report& report) {
  const auto earlier = folder.earlier();
  if (!earlier.is_null()) {
    report.rows = report::rowsToResume(earlier, report);
  }
}

/// Prints paragraphs and tables to a terminal.
void print(const std::vector<report::Block>& blocks) {
  for (const report::Block& block : blocks) {
    if (const auto* paragraph = std::get_if<report::Paragraph>(&block)) {
      std::cout << paragraph->text << '\n';
    } else if (const auto* table = std::get_if<report::TextTable>(&block)) {
      std::cout << report::plainText(*table);
    }
  }
}

/// The result for one's own cloth.
std::vector<report::Block> budgetBlocks(const report::Report& report) {
  for (const report::Section& section : report::sectionTable()) {
    if (section.name == report::budgetSection) {
      return section.show(report.options, report::rowsOf(report, section));
    }
  }
  return {};
}

/// Compares the report with the earlier one; true when something changed.
bool compare(const nlohmann::ordered_json& older, report::Report& report) {
  if (older.is_null()) {
    return false;
  }
  report.comparison = report::compareReports(older, report);
  print(report::showComparison(report.comparison));
  return !report.comparison["moved"].empty();
}

/// Whether something changed since the earlier report.
bool run(const ReportArguments& arguments, StopSignal& stop) {
  requireConsistent(arguments);
  report::requireSections(arguments.options);
  report::Report report = emptyReport(optionsOf(arguments));
  nlohmann::ordered_json older;
  if (!arguments.compare.empty()) {
    older = readReport(arguments.compare);  // read it now: the program may overwrite this file
    report::requireComparable(older, report);
  }
  std::optional<ReportFolder> folder;  // not before: wrong usage leaves no empty folder
  if (!arguments.output.empty()) {
    folder.emplace(arguments.output);
  }
  if (arguments.resume) {
    resume(*folder, report);
  }
  ReportSaver saver(folder, report);
  {
    ProgressLine progress(ProgressLine::Style::TimeLeft);
    report::RunHooks hooks;
    const double repeatTime = report.options.quick ? repeatTimeOfQuick : repeatTimeOfFull;
    hooks.stopped = [&] { return stop.came(); };
    hooks.progress = [&progress](std::string_view section, double done, double total) {
      progress.show(section, done, total);
    };
    hooks.outOfTime = [&] { return progress.spent() > repeatTime; };
    hooks.measured = [&saver](const report::SectionRows&) { saver.save(); };
    report.complete = report::measureSections(report.options, report.rows, hooks);
  }
  const bool moved = compare(older, report);
  if (report.options.own) {
    print(budgetBlocks(report));
  }
  if (folder) {
    folder->writeAll(report);
    std::cout << "written to " << arguments.output << "/report.html, report.md and report.json\n";
  }
  if (!report.complete) {
    throw messages::InputError(folder ? "stopped before the end; --resume continues from here"
                                      : "stopped before the end");
  }
  return moved;
}

}  // namespace
}  // namespace drape::app

int main(int argc, char** argv) {
  drape::app::StopSignal stop;
  drape::app::ReportArguments arguments;
  CLI::App app("Measures the cost and the errors of the methods, and writes a report", "drape-report");
  drape::app::addTo(app, arguments);
  constexpr int somethingMoved = 3;
  bool moved = false;
  const int status = drape::app::runProgram(app, argc, argv, [&] { moved = drape::app::run(arguments, stop); });
  return status == 0 && moved ? somethingMoved : status;
}
