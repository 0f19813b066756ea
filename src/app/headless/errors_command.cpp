#include "app/command_line.hpp"
#include "app/error_sources_json.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/output_file.hpp"
#include "app/progress_line.hpp"
#include "app/used_files.hpp"
#include "messages/error_sources_text.hpp"
#include "report/error_sources.hpp"
#include "text/number_text.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct ErrorsArguments {
  SceneArguments scene;
  report::ErrorSourcesPlan plan;
  std::string json;
};

constexpr double maxTime = 10.0;  // [s]; later a motion hardly depends on its start

std::string millimetres(double metres) {
  return std::isfinite(metres) ? text::formatNumber(metres * 1e3) : "blew up";
}

void printTable(const std::vector<sim::ErrorSources>& sources) {
  std::cout << fmt::format("{:>8} {:>12} {:>12} {:>12} {:>12}   mean distances [mm]\n", "time [s]", "method", "mesh",
                           "material", "start");
  for (const sim::ErrorSources& at : sources) {
    std::cout << fmt::format("{:>8} {:>12} {:>12} {:>12} {:>12}\n", text::formatNumber(at.time), millimetres(at.method),
                             millimetres(at.mesh), millimetres(at.material), millimetres(at.start));
  }
  std::cout << messages::inWords(sources.back()).english() << '\n';
}

void run(ErrorsArguments& arguments) {
  const auto scene = arguments.scene.load();
  std::ranges::sort(arguments.plan.times);
  std::optional<OutputFile> file;
  UsedFiles(*scene).write(arguments.json, "--json");
  if (!arguments.json.empty()) {
    file.emplace(arguments.json, "the sources of error");
  }
  printSolverWarnings(scene->settings, *scene->model);
  arguments.plan.threads = scene->settings.step.threads;
  ProgressLine bar(ProgressLine::Style::TimeLeft);
  const std::vector<sim::ErrorSources> sources = report::measureErrorSources(
      scene->description, scene->settings, arguments.plan, [&](double part) { bar.show("comparing", part, 1.0); });
  printTable(sources);
  if (file) {
    file->write({{"scene", scene->description.name}, {"sources", toJson(sources)}});
  }
}

}  // namespace

void addErrorsCommand(CLI::App& app) {
  auto arguments = std::make_shared<ErrorsArguments>();
  CLI::App* command =
      app.add_subcommand("errors", "Compares the sources of error: the method, the mesh, the material and the start");
  arguments->scene.addTo(*command);
  command
      ->add_option("--times", arguments->plan.times,
                   "Times since the start [s]; multiples of 1/30 s, rounded; default 0.2,0.5")
      ->delimiter(',')
      ->type_name("T,...")
      ->check(numberFrom(0.0, maxTime));
  command
      ->add_option("--tolerance", arguments->plan.referenceTolerance,
                   "Error tolerance of the accurate runs [m]; default 1e-5")
      ->check(numberFrom(1e-9, 1.0));
  command->add_option("--json", arguments->json, "Write the result to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->callback([arguments] { run(*arguments); });
}

}  // namespace drape::app
