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

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

namespace drape::app {
namespace {

/// Time limits: a report should end within 25 minutes, a quick one within 90 s. After `forRepeats` nothing is measured
/// a second time; after `forAll`, on a slow machine, nothing at all [s].
struct Allowance {
  double forRepeats;
  double forAll;
};
constexpr Allowance allowanceOfFull{22.0 * 60.0, 24.5 * 60.0};
constexpr Allowance allowanceOfQuick{60.0, HUGE_VAL};  // tests expect all of its sections

struct ReportArguments {
  report::ReportOptions options{.quick = false, .scene = {}, .threads = 1, .only = {}};
  std::string output;
  std::string compare;
  bool resume = false;
};

void addTo(CLI::App& app, ReportArguments& arguments) {
  constexpr int maxThreads = 64;
  std::string sections;
  for (const report::Section& section : report::sectionTable()) {
    if (section.plan != nullptr) {
      sections += sections.empty() ? "" : ", ";
      sections += section.name;
    }
  }
  app.add_flag("--quick", arguments.options.quick, "Fewer and smaller measurements: about a minute");
  app.add_option("--only", arguments.options.only, "Measure only this section (" + sections + "); may be repeated")
      ->type_name("SECTION")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  app.add_option("--scene", arguments.options.scene,
                 "Compare methods on this scene only: hang, flag, crush, twist or any scene with a grid")
      ->type_name("NAME")
      ->check(notEmpty());
  app.add_option("--threads", arguments.options.threads,
                 "Threads of a step in measurements that do not compare methods (1)")
      ->check(CLI::Range(1, maxThreads));
  app.add_flag("--resume", arguments.resume, "Continue the report.json in the folder");
  app.add_option("--compare", arguments.compare,
                 "List changes beyond noise since this earlier report.json; exit status 3 when there are any")
      ->type_name("OLD.json")
      ->check(notEmpty());
  app.add_option("--output", arguments.output, "Folder for report.html, report.md and report.json")
      ->type_name("DIR")
      ->required()
      ->check(notEmpty());
}

/// Saves the measurements every few seconds, since the program may be killed.
class ReportSaver {
 public:
  ReportSaver(const ReportFolder& folder, report::Report& report) : folder_(folder), report_(report) {}

  void save() {
    constexpr std::chrono::seconds pause(5);
    if (std::chrono::steady_clock::now() - last_ > pause) {
      folder_.writeJson(report_);
      last_ = std::chrono::steady_clock::now();
    }
  }

 private:
  const ReportFolder& folder_;
  report::Report& report_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

report::Report prepare(const ReportArguments& arguments, const ReportFolder& folder) {
  report::Report report;
  report.machine = report::machineJson(report::buildInfo());
  report.options = arguments.options;
  if (arguments.resume) {
    const auto earlier = folder.earlier();
    if (!earlier.is_null()) {
      report.rows = report::rowsToResume(earlier, report);
    }
  }
  return report;
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
  (void)report::sections::comparedSetUps(arguments.options.scene);  // reports wrong names before the measurements
  const ReportFolder folder(arguments.output);
  report::Report report = prepare(arguments, folder);
  nlohmann::ordered_json older;
  if (!arguments.compare.empty()) {
    older = readReport(arguments.compare);  // read it now: the program may overwrite this file
    report::requireComparable(older, report);
  }
  ReportSaver saver(folder, report);
  {
    ProgressLine progress(ProgressLine::Style::TimeLeft);
    report::RunHooks hooks;
    const Allowance allowance = report.options.quick ? allowanceOfQuick : allowanceOfFull;
    hooks.stopped = [&] { return stop.came() || progress.spent() > allowance.forAll; };
    hooks.progress = [&progress](std::string_view section, double done, double total) {
      progress.show(section, done, total);
    };
    hooks.outOfTime = [&] { return progress.spent() > allowance.forRepeats; };
    hooks.measured = [&saver](const report::SectionRows&) { saver.save(); };
    report.complete = report::measureSections(report.options, report.rows, hooks);
  }
  const bool moved = compare(older, report);
  folder.writeAll(report);
  std::cout << "written to " << arguments.output << "/report.html, report.md and report.json\n";
  if (!report.complete) {
    throw messages::InputError("stopped before the end; --resume continues from here");
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
