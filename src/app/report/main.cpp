#include "app/command_line.hpp"
#include "app/report/progress_line.hpp"
#include "app/report/report_folder.hpp"
#include "app/report/stop_signal.hpp"
#include "build_info.hpp"
#include "report/comparison.hpp"
#include "report/machine.hpp"
#include "report/plain_text.hpp"
#include "report/sections/set_ups.hpp"
#include "sim/error.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

namespace drape {
namespace {

/// A report is to end within 20 minutes, a quick one within 90 s. When `forRepeats` is over nothing is measured a
/// second time, and when `forAll` is, on a slow machine, nothing at all [s].
struct Allowance {
  double forRepeats;
  double forAll;
};
constexpr Allowance allowanceOfFull{17.0 * 60.0, 19.5 * 60.0};
constexpr Allowance allowanceOfQuick{60.0, HUGE_VAL};  // tests look for all that is in it

struct ReportArguments {
  ReportOptions options{.quick = false, .scene = {}, .threads = 1, .only = {}};
  std::string output;
  std::string compare;
  bool resume = false;
};

void addTo(CLI::App& app, ReportArguments& arguments) {
  constexpr int mostThreads = 64;
  std::string sections;
  for (const Section& section : sectionTable()) {
    if (section.plan != nullptr) {
      sections += sections.empty() ? "" : ", ";
      sections += section.name;
    }
  }
  app.add_flag("--quick", arguments.options.quick, "Fewer and smaller measurements: about a minute");
  app.add_option("--only", arguments.options.only, "Measure this section alone (" + sections + "); may be repeated")
      ->type_name("SECTION")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check(notEmpty());
  app.add_option("--scene", arguments.options.scene,
                 "Compare methods on this scene alone: hang, flag, crush, twist or any scene with a grid")
      ->type_name("NAME")
      ->check(notEmpty());
  app.add_option("--threads", arguments.options.threads, "Threads a step may use where methods are not compared (1)")
      ->check(CLI::Range(1, mostThreads));
  app.add_flag("--resume", arguments.resume, "Go on with the report.json that is in the folder");
  app.add_option("--compare", arguments.compare,
                 "Tell what moved beyond noise since this earlier report.json; exit status 3 when something did")
      ->type_name("OLD.json")
      ->check(notEmpty());
  app.add_option("--output", arguments.output, "The folder to write report.html, report.md and report.json to")
      ->type_name("DIR")
      ->required()
      ->check(notEmpty());
}

/// Keeps what has been measured on disk, every few seconds: the program may be ended by force.
class Keeper {
 public:
  Keeper(const ReportFolder& folder, Report& report) : folder_(folder), report_(report) {}

  void keep() {
    constexpr std::chrono::seconds pause(5);
    if (std::chrono::steady_clock::now() - last_ > pause) {
      folder_.writeJson(report_);
      last_ = std::chrono::steady_clock::now();
    }
  }

 private:
  const ReportFolder& folder_;
  Report& report_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Report prepare(const ReportArguments& arguments, const ReportFolder& folder) {
  Report report;
  report.machine = machineJson(buildInfo());
  report.options = arguments.options;
  if (arguments.resume) {
    const auto earlier = folder.earlier();
    if (!earlier.is_null()) {
      report.rows = rowsToResume(earlier, report);
    }
  }
  return report;
}

/// Paragraphs and tables for a terminal.
void print(const std::vector<Block>& blocks) {
  for (const Block& block : blocks) {
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) {
      std::cout << paragraph->text << '\n';
    } else if (const auto* table = std::get_if<TextTable>(&block)) {
      std::cout << plainText(*table);
    }
  }
}

/// Holds the report against the earlier one; true when something moved.
bool compare(const nlohmann::ordered_json& older, Report& report) {
  if (older.is_null()) {
    return false;
  }
  report.comparison = compareReports(older, report);
  print(showComparison(report.comparison));
  return !report.comparison["moved"].empty();
}

/// Returns whether something moved since the report to compare with.
bool run(const ReportArguments& arguments, StopSignal& stop) {
  (void)comparedSetUps(arguments.options.scene);  // wrong names are told before anything is done
  const ReportFolder folder(arguments.output);
  Report report = prepare(arguments, folder);
  nlohmann::ordered_json older;
  if (!arguments.compare.empty()) {
    older = readReport(arguments.compare);  // now: it may be the file that is about to be written
    requireComparable(older, report);
  }
  Keeper keeper(folder, report);
  {
    ProgressLine progress;
    RunHooks hooks;
    const Allowance allowance = report.options.quick ? allowanceOfQuick : allowanceOfFull;
    hooks.stopped = [&] { return stop.came() || progress.spent() > allowance.forAll; };
    hooks.progress = [&progress](std::string_view section, double done, double total) {
      progress.show(section, done, total);
    };
    hooks.outOfTime = [&] { return progress.spent() > allowance.forRepeats; };
    hooks.measured = [&keeper](const SectionRows&) { keeper.keep(); };
    report.complete = measureSections(report.options, report.rows, hooks);
  }
  const bool moved = compare(older, report);
  folder.writeAll(report);
  std::cout << "written to " << arguments.output << "/report.html, report.md and report.json\n";
  if (!report.complete) {
    throw InputError("stopped before the end; --resume goes on from here");
  }
  return moved;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) {
  drape::StopSignal stop;
  drape::ReportArguments arguments;
  CLI::App app("Measures what the methods cost and how wrong they are, and writes a report", "drape-report");
  drape::addTo(app, arguments);
  constexpr int somethingMoved = 3;
  bool moved = false;
  const int status = drape::runProgram(app, argc, argv, [&] { moved = drape::run(arguments, stop); });
  return status == 0 && moved ? somethingMoved : status;
}
