#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/intact.hpp"
#include "app/headless/intersection_watch.hpp"
#include "app/headless/position_writer.hpp"
#include "app/headless/run_stats.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/progress_bar.hpp"
#include "session/simulation.hpp"
#include "sim/diagnostics.hpp"
#include "sim/error.hpp"
#include "sim/stability.hpp"

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace drape {
namespace {

struct RunArguments {
  SceneArguments scene;
  double seconds = 1.0;
  int threads = 1;
  std::string stats;
  std::string positions;
  double every = 0.0;
  std::int64_t checkIntersections = 0;
};

/// Longer runs would take days and are probably a mistake.
constexpr double maxSeconds = 1e5;
constexpr double maxSteps = 1e9;

std::int64_t stepsFor(double seconds, double timeStep) {
  const double steps = std::round(seconds / timeStep);
  if (steps > maxSteps) {
    throw UsageError(
        "--seconds divided by time_step gives more than a thousand million steps; use fewer seconds "
        "or a longer step");
  }
  return static_cast<std::int64_t>(steps);
}

/// Prints the contents of a mesh file and how it was repaired. Prints nothing for a grid.
void printMesh(const Scene& scene) {
  if (std::holds_alternative<MeshFileSource>(scene.description.source)) {
    for (const std::string& line : describe(scene.summary)) {
      std::cout << line << '\n';
    }
  }
}

/// Prints the solver's stability limit, if it has one.
void printStabilityLimit(const nlohmann::ordered_json& limit) {
  if (limit.is_number()) {
    const auto seconds = limit.get<double>();
    std::cout << "stability limit: " << (seconds > 0.0 ? stepInWords(seconds) : "no step is stable") << '\n';
  }
}

void printSummary(const Simulation& simulation, const nlohmann::ordered_json& json) {
  printMesh(simulation.scene());
  std::ostringstream figures;
  figures.precision(3);
  figures << json["step_us"]["median"].get<double>() << " us a step (median), largest stretch "
          << maxStretch(simulation.model(), simulation.state());
  std::cout << simulation.scene().description.title << ": " << json["vertices"] << " vertices, " << json["springs"]
            << " springs, " << json["triangles"] << " triangles\n"
            << json["steps"] << " steps to " << simulation.state().time << " s, " << figures.str() << ", state "
            << json["state_hash"].get<std::string>() << '\n';
  printStabilityLimit(json["stability_limit"]);
}

/// Prints warnings. A cloth that blew up is an error, which is reported at the end.
void warn(const Simulation& simulation) {
  Snapshot end;
  simulation.capture(end);
  if (!end.message.empty() && !simulation.blewUp()) {
    std::cerr << "warning: " << end.message << '\n';
  }
  if (end.overstretched && !end.overstretched->advice.key.empty()) {
    const Advice& advice = end.overstretched->advice;
    std::cerr << "note: --set " << advice.key << '=' << advice.value << " would help\n";
  }
}

void run(RunArguments arguments) {
  arguments.scene.settings.push_back("threads=" + std::to_string(arguments.threads));
  if (!arguments.positions.empty() && !(arguments.every > 0.0)) {
    throw UsageError("--positions needs --every SECONDS: the simulated time between two samples");
  }
  Simulation simulation(arguments.scene.load());
  printSolverWarnings(simulation.settings(), simulation.model());
  const double timeStep = simulation.settings().step.timeStep;
  const std::int64_t steps = stepsFor(arguments.seconds, timeStep);
  std::optional<PositionWriter> positions;
  if (!arguments.positions.empty()) {
    positions.emplace(arguments.positions, arguments.every, timeStep);
    positions->sample(simulation.state());
  }
  std::optional<IntersectionWatch> intersections;
  if (arguments.checkIntersections > 0) {
    intersections.emplace(arguments.checkIntersections);
    intersections->observe(simulation);
  }
  RunStats stats(arguments.stats, steps);
  {
    ProgressBar progress("simulating", steps);
    for (std::int64_t i = 0; i < steps && !simulation.blewUp(); ++i) {
      simulation.step();
      stats.add(simulation);
      if (positions) {
        positions->sample(simulation.state());
      }
      if (intersections) {
        intersections->observe(simulation);
      }
      progress.show(i + 1);
    }
  }
  warn(simulation);
  auto figures = stats.toJson(simulation);
  if (intersections) {
    intersections->finish(simulation);
    intersections->addTo(figures);
  }
  stats.write(figures);
  if (positions) {
    positions->close();
  }
  printSummary(simulation, figures);
  if (intersections) {
    std::cout << intersections->summary() << '\n';
  }
  requireIntact(simulation);
}

}  // namespace

void addRunCommand(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Simulates without drawing and writes statistics");
  arguments->scene.addTo(*command);
  command->add_option("--seconds", arguments->seconds, "Simulated time [s]")
      ->required()
      ->check(numberFrom(0.0, maxSeconds));
  command->add_option("--threads", arguments->threads,
                      "Maximum number of threads of a step; the result does not depend on it");
  command->add_option("--stats", arguments->stats, "Write the statistics of the run to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--positions", arguments->positions, "Write positions to this file (CSV)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--every", arguments->every, "Simulated time between two samples of positions [s]")
      ->check(numberFrom(1e-6, maxSeconds));
  command
      ->add_option("--check-intersections", arguments->checkIntersections,
                   "Count intersecting triangles exactly, at every N-th step and the last")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, static_cast<std::int64_t>(maxSteps)));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace drape
