#include "app/command_line.hpp"
#include "app/report/progress_line.hpp"
#include "app/report/report_folder.hpp"
#include "app/report/stop_signal.hpp"
#include "build_info.hpp"
#include "report/machine.hpp"
#include "sim/error.hpp"

#include <chrono>
#include <iostream>
#include <string>

namespace drape {
namespace {

struct ReportArguments {
  ReportOptions options{.quick = false, .scene = "grid", .threads = 1, .only = {}};
  std::string output;
  bool resume = false;
};

void addTo(CLI::App& app, ReportArguments& arguments) {
  constexpr int mostThreads = 64;
  std::string sections;
  for (const Section& section : sectionTable()) {
    sections += sections.empty() ? "" : ", ";
    sections += section.name;
  }
  app.add_flag("--quick", arguments.options.quick, "Fewer and smaller measurements: about a minute");
  app.add_option("--only", arguments.options.only, "Measure this section alone (" + sections + "); may be repeated")
      ->type_name("SECTION")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--scene", arguments.options.scene, "The scene with a grid that methods are compared on (grid)")
      ->type_name("NAME");
  app.add_option("--threads", arguments.options.threads, "Threads a step may use where methods are not compared (1)")
      ->check(CLI::Range(1, mostThreads));
  app.add_flag("--resume", arguments.resume, "Go on with the report.json that is in the folder");
  app.add_option("--output", arguments.output, "The folder to write report.html, report.md and report.json to")
      ->type_name("DIR")
      ->required();
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

void run(const ReportArguments& arguments, StopSignal& stop) {
  const SceneDescription scene = openScene(arguments.options.scene);  // wrong names are told before anything is done
  if (!std::holds_alternative<GridSource>(scene.source)) {
    throw InputError("the report refines its cloth, so it needs a scene with a grid; " + arguments.options.scene +
                     " has a mesh file");
  }
  const ReportFolder folder(arguments.output);
  Report report = prepare(arguments, folder);
  Keeper keeper(folder, report);
  {
    ProgressLine progress;
    RunHooks hooks;
    hooks.stopped = [&stop] { return stop.came(); };
    hooks.progress = [&progress](std::string_view section, double done, double total) {
      progress.show(section, done, total);
    };
    hooks.measured = [&keeper](const SectionRows&) { keeper.keep(); };
    report.complete = measureSections(report.options, report.rows, hooks);
  }
  folder.writeAll(report);
  std::cout << "written to " << arguments.output << "/report.html, report.md and report.json\n";
  if (!report.complete) {
    throw InputError("stopped before the end; --resume goes on from here");
  }
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) {
  drape::StopSignal stop;
  drape::ReportArguments arguments;
  CLI::App app("Measures what the methods cost and how wrong they are, and writes a report", "drape-report");
  drape::addTo(app, arguments);
  return drape::runProgram(app, argc, argv, [&] { drape::run(arguments, stop); });
}
