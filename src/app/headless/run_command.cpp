#include "app/command_line.hpp"
#include "app/export/frame_rate.hpp"
#include "app/export/motion_export.hpp"
#include "app/export/output_name.hpp"
#include "app/headless/checkpoint_file.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/end_warnings.hpp"
#include "app/headless/intact.hpp"
#include "app/headless/intersection_watch.hpp"
#include "app/headless/pierced_start.hpp"
#include "app/headless/position_writer.hpp"
#include "app/headless/probe_writer.hpp"
#include "app/headless/run_stats.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/progress_line.hpp"
#include "app/session_log.hpp"
#include "app/used_files.hpp"
#include "messages/accuracy_text.hpp"
#include "messages/error.hpp"
#include "messages/solver_warning_text.hpp"
#include "messages/step_choice_text.hpp"
#include "report/jittered_start.hpp"
#include "scene/cloth_material.hpp"
#include "scene/rest_pattern.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace drape::app {
namespace {

struct RunArguments {
  SceneArguments scene;
  std::optional<double> seconds;
  int threads = 1;
  std::string replay;  // the file of a session log
  std::string stats;
  std::string positions;
  double every = 0.0;
  std::int64_t checkIntersections = 0;
  int jitter = 0;
  ExportArguments exports;
  ProbeArguments probes;
  std::string save;    // the file of a checkpoint
  std::string resume;  // likewise
};

/// Longer runs would take days and are probably a mistake.
constexpr double longestRun = 1e5;
constexpr double maxSteps = 1e9;

std::int64_t stepsFor(double seconds, double timeStep) {
  const double steps = std::round(seconds / timeStep);
  if (steps > maxSteps) {
    throw messages::UsageError(
        "--seconds divided by time_step gives more than a thousand million steps; use fewer seconds "
        "or a longer step");
  }
  return static_cast<std::int64_t>(steps);
}

/// Prints the contents of mesh files. Prints nothing for grids.
void printMesh(const scene::Scene& scene) {
  const auto isFile = [](const scene::ClothDescription& cloth) {
    return std::holds_alternative<scene::MeshFileSource>(cloth.source);
  };
  if (std::ranges::any_of(scene.description.cloths, isFile)) {
    for (const std::string& line : io::describe(scene.summary)) {
      std::cout << line << '\n';
    }
  }
}

/// Prints the solver's stability limit, if it has one.
void printStabilityLimit(const nlohmann::ordered_json& limit) {
  if (limit.is_number()) {
    const auto seconds = limit.get<double>();
    std::cout << "stability limit: " << (seconds > 0.0 ? messages::stepInWords(seconds) : "no step is stable") << '\n';
  }
}

/// Prints the name of the fabric, where its warp comes from, and its clamped triangles. Prints nothing for springs.
void printFabric(const session::Simulation& simulation) {
  if (!simulation.model().fabric) {
    return;
  }
  const int slivers = simulation.model().fabric->slivers;
  std::cout << "fabric: " << scene::fabricsInWords(simulation.scene().cloths, simulation.settings()) << "; warp "
            << scene::warpInWords(simulation.scene().cloths, simulation.settings()) << "; "
            << (slivers == 0 ? "no sliver has a lowered stiffness"
                             : fmt::format("slivers: the stiffness of {} of {} triangles is lowered", slivers,
                                           simulation.model().triangles.size()))
            << '\n';
  if (simulation.model().fabric->meshStrain) {
    std::cout << "rest shape: "
              << scene::restShapeInWords(simulation.model(), simulation.scene().cloths.front().uvs,
                                         simulation.settings())
              << '\n';
  }
}

/// Prints what `auto` chose for the last step.
void printChoice(const session::Simulation& simulation) {
  if (const auto& choice = simulation.lastStepReport().choice) {
    std::cout << "last step: "
              << messages::inWords(*choice, scene::materialInWords(simulation.scene().cloths, simulation.settings(),
                                                                   choice->softestMaterial))
              << '\n';
  }
}

/// Prints the last check of the error, if there was one.
void printAccuracy(const session::Simulation& simulation) {
  if (const auto accuracy = simulation.accuracy()) {
    std::cout << fmt::format("at {:.2f} s: position error {}\n", accuracy->time,
                             messages::inWords(*accuracy).english());
  }
}

void printSummary(const session::Simulation& simulation, const nlohmann::ordered_json& json) {
  printMesh(simulation.scene());
  std::cout << simulation.scene().description.title << ": " << json["vertices"] << " vertices, " << json["springs"]
            << " springs, " << json["triangles"] << " triangles\n"
            << json["steps"] << " steps to " << simulation.state().time
            << fmt::format(" s, {:.3g} us a step (median), largest stretch {:.3g}, state {}\n",
                           json["step_us"]["median"].get<double>(),
                           sim::maxStretch(simulation.model(), simulation.state()),
                           json["state_hash"].get<std::string>());
  printFabric(simulation);
  printStabilityLimit(json["stability_limit"]);
  printChoice(simulation);
  printAccuracy(simulation);
}

/// The figures, positions and checks of a run, one step after the other.
class RunOutputs {
 public:
  /// @param files that the run reads and writes, without those of exports
  RunOutputs(const RunArguments& arguments, session::Simulation& simulation, std::int64_t steps, UsedFiles files)
      : stats_(arguments.stats, steps), progress_(std::in_place), steps_(static_cast<double>(steps)) {
    if (!arguments.exports.files.empty()) {
      exports_.emplace(arguments.exports, simulation, steps);
      for (const std::filesystem::path& file : exports_->files()) {
        files.write(file, "--export");
      }
    }
    if (!arguments.positions.empty()) {
      positions_.emplace(arguments.positions, arguments.every, simulation.settings().step.timeStep);
      positions_->sample(simulation.state());
    }
    if (arguments.checkIntersections > 0) {
      intersections_.emplace(arguments.checkIntersections);
      intersections_->observe(simulation);
    }
    if (!arguments.probes.vertices.empty()) {
      probes_.emplace(arguments.probes, simulation);
    }
  }

  void addStep(const session::Simulation& simulation) {
    stats_.add(simulation);
    if (positions_) {
      positions_->sample(simulation.state());
    }
    if (intersections_) {
      intersections_->observe(simulation);
    }
    if (exports_) {
      exports_->sample(simulation);
    }
    if (probes_) {
      probes_->sample(simulation);
    }
    progress_->show("simulating", ++taken_, steps_);
  }

  /// Writes the files and prints the summary.
  void finish(const session::Simulation& simulation) {
    progress_.reset();
    printEndWarnings(simulation);
    auto figures = stats_.toJson(simulation);
    if (intersections_) {
      intersections_->finish(simulation);
      intersections_->addTo(figures);
    }
    stats_.write(figures);
    if (positions_) {
      positions_->close();
    }
    if (probes_) {
      probes_->close();
    }
    if (exports_) {
      exports_->finish(simulation, simulation.state().positions);
    }
    printSummary(simulation, figures);
    if (intersections_) {
      std::cout << intersections_->summary() << '\n';
    }
    if (exports_) {
      for (const std::string& line : exports_->summary()) {
        std::cout << line << '\n';
      }
    }
  }

 private:
  RunStats stats_;
  std::optional<PositionWriter> positions_;
  std::optional<IntersectionWatch> intersections_;
  std::optional<MotionExport> exports_;
  std::optional<ProbeWriter> probes_;
  std::optional<ProgressLine> progress_;
  double steps_;
  double taken_ = 0.0;
};

/// The files of a run, without those of exports.
UsedFiles filesOf(const RunArguments& arguments, const scene::Scene& scene) {
  UsedFiles files(scene);
  files.read(arguments.scene.fabrics);
  files.read(arguments.replay);
  files.write(withSettings(arguments.save, scene.settings), "--save");  // may replace the checkpoint of --resume
  files.read(arguments.resume);
  files.write(arguments.stats, "--stats");
  files.write(arguments.positions, "--positions");
  files.write(arguments.probes.file, "--probe-output");
  return files;
}

/// Runs a recorded session again. It must end in the same bits.
void replay(const RunArguments& arguments) {
  // The number of threads is that of this run. A wrong one is an error of the command line, not of the log.
  settings::Settings ofThisRun;
  settings::assignSettingExpression(ofThisRun, "threads=" + std::to_string(arguments.threads));
  SessionLog log = readSessionLog(arguments.replay);
  log.settings.emplace_back("threads", std::to_string(arguments.threads));
  const auto scene = openLoggedScene(log);
  printMeshWarnings(*scene);
  session::Simulation simulation(scene);
  RunOutputs outputs(arguments, simulation, log.steps, filesOf(arguments, *scene));
  simulation.replay(log.commands, log.steps, [&] { outputs.addStep(simulation); });
  outputs.finish(simulation);
  const std::string hash = sim::toHex(sim::stateHash(simulation.state()));
  if (hash != log.stateHash) {
    throw messages::InputError(arguments.replay + ": the replay ends in state " + hash +
                               ", the session ended in state " + log.stateHash +
                               ". Either a mesh file or the version of Drape has changed since.");
  }
  std::cout << "the replay ends in the same state as the session\n";
}

/// The number of steps to the end of the run.
std::int64_t stepsLeft(double seconds, const session::Simulation& simulation) {
  const double left = seconds - simulation.state().time;
  const double timeStep = simulation.settings().step.timeStep;
  if (left < -0.5 * timeStep) {
    throw messages::UsageError(
        fmt::format("the checkpoint is at {:.6g} s; --seconds is the end of the whole run and must not be before",
                    simulation.state().time));
  }
  const std::int64_t steps = stepsFor(std::max(0.0, left), timeStep);
  constexpr double rounding = 1e-6;  // of the time, relative to a step
  if (steps == 0 && left > rounding * timeStep) {
    std::cerr << fmt::format(
        "warning: --seconds {:.6g} leaves less than half of a time step of {:.6g} s; no step is taken\n", seconds,
        timeStep);
  }
  return steps;
}

void run(RunArguments arguments) {
  if (!arguments.positions.empty() && !(arguments.every > 0.0)) {
    throw messages::UsageError("--positions needs --every SECONDS: the simulated time between two samples");
  }
  if (!arguments.replay.empty()) {
    replay(arguments);
    return;
  }
  if (!arguments.seconds) {
    throw messages::UsageError("--seconds is required: the simulated time [s]. Only --replay does without it.");
  }
  arguments.scene.settings.push_back("threads=" + std::to_string(arguments.threads));
  if (arguments.exports.hasFrames()) {
    arguments.scene.adjust = fitTimeStep(arguments.exports.frameRate(), arguments.scene.settings);
  }
  const auto scene = report::withJitteredStart(arguments.scene.load(), arguments.jitter);
  UsedFiles files = filesOf(arguments, *scene);
  if (arguments.resume.empty()) {
    printPiercedStart(scene);
  }
  session::Simulation simulation(scene);
  printSolverWarnings(simulation.settings(), simulation.model());
  if (!arguments.resume.empty()) {
    for (const std::string& change : resumeFrom(arguments.resume, simulation)) {
      std::cerr << "note: " << change << '\n';
    }
  }
  std::optional<CheckpointFile> save;
  if (!arguments.save.empty()) {
    save.emplace(withSettings(arguments.save, simulation.settings()), simulation);
  }
  const std::int64_t steps = stepsLeft(*arguments.seconds, simulation);
  RunOutputs outputs(arguments, simulation, steps, std::move(files));
  for (std::int64_t i = 0; i < steps && !simulation.blewUp(); ++i) {
    simulation.step();
    outputs.addStep(simulation);
  }
  outputs.finish(simulation);
  requireIntact(simulation);
  if (save) {
    save->write(simulation);
  }
}

}  // namespace

void addRunCommand(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Simulates without drawing and writes statistics");
  arguments->scene.addTo(*command);
  command
      ->add_option("--jitter", arguments->jitter,
                   "Move each free vertex of the start by up to 1 % of an edge; the number is the seed, 0: not")
      ->type_name("SEED")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()));
  arguments->exports.addTo(*command);
  for (const char* option : {"--rate", "--coordinates"}) {
    command->get_option(option)->needs("--export");
  }
  arguments->probes.addTo(*command);
  command->add_option("--save", arguments->save, "Write a checkpoint at the end, from which --resume continues")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option("--resume", arguments->resume, "Continue from a checkpoint, to the same bits; --seconds is the end")
      ->type_name("FILE")
      ->check(notEmpty());
  CLI::Option* seconds =
      command->add_option("--seconds", arguments->seconds, "Simulated time [s]")->check(numberFrom(0.0, longestRun));
  command
      ->add_option("--replay", arguments->replay,
                   "Run a session again that 'drape --record' wrote, and check that it ends in the same bits")
      ->type_name("LOG")
      ->check(notEmpty())
      ->excludes(seconds)
      ->excludes("scene")
      ->excludes("--set")
      ->excludes("--fabrics")
      ->excludes("--jitter")
      ->excludes("--export")
      ->excludes("--save")
      ->excludes("--resume");
  command->add_option("--threads", arguments->threads,
                      "Maximum number of threads of a step; the result does not depend on it");
  command->add_option("--stats", arguments->stats, "Write the statistics of the run to this file (JSON)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--positions", arguments->positions, "Write positions to this file (CSV)")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--every", arguments->every, "Simulated time between two samples of positions [s]")
      ->check(numberFrom(1e-6, longestRun))
      ->needs("--positions");
  command
      ->add_option("--check-intersections", arguments->checkIntersections,
                   "Count intersecting triangles exactly, at every N-th step and the last")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, static_cast<std::int64_t>(maxSteps)));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace drape::app
