#include "app/command_line.hpp"
#include "app/export/frame_rate.hpp"
#include "app/export/output_name.hpp"
#include "app/export/picture_files.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/end_warnings.hpp"
#include "app/headless/intact.hpp"
#include "app/headless/pierced_start.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/headless/view_arguments.hpp"
#include "app/progress_line.hpp"
#include "app/report/stop_signal.hpp"
#include "messages/error.hpp"
#include "session/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct CaptureArguments {
  SceneArguments scene;
  int frames = 1;
  int every = 0;
  std::optional<double> rate;
  std::string output;
  ViewArguments view;
};

/// Without --every the time between frames is close to this, in whole steps [s].
constexpr double usualFrame = 1.0 / 30.0;

/// Time steps between two pictures.
int stepsBetween(const CaptureArguments& arguments, double timeStep) {
  if (arguments.rate) {
    return stepsPerFrame(*arguments.rate, timeStep);
  }
  return arguments.every > 0 ? arguments.every : std::max(1, static_cast<int>(std::lround(usualFrame / timeStep)));
}

/// Simulates and draws until all pictures are made or a signal arrives.
void draw(const CaptureArguments& arguments, int every, session::Simulation& simulation, StopSignal& stop,
          PictureFiles& pictures) {
  const std::unique_ptr<PictureMaker> maker = arguments.view.makerFor(simulation);
  ProgressLine progress;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    for (int i = 0; frame > 0 && i < every && !simulation.blewUp() && !stop.came(); ++i) {
      simulation.step();
    }
    if (frame > 0 && stop.came()) {
      return;
    }
    pictures.add(maker->draw(simulation));
    progress.show("capturing", frame + 1, arguments.frames);
  }
}

void capture(CaptureArguments arguments) {
  StopSignal stop;
  if (arguments.rate) {
    arguments.scene.adjust = fitTimeStep(*arguments.rate, arguments.scene.settings);
  }
  const auto scene = arguments.scene.load();
  printPiercedStart(scene);
  session::Simulation simulation(scene);
  printSolverWarnings(simulation.settings(), simulation.model());
  const double timeStep = simulation.settings().step.timeStep;
  const int every = stepsBetween(arguments, timeStep);
  PictureFiles pictures(withSettings(arguments.output, simulation.settings()), arguments.frames,
                        arguments.view.resolution[0], arguments.view.resolution[1],
                        arguments.rate.value_or(1.0 / (every * timeStep)));
  draw(arguments, every, simulation, stop, pictures);
  printEndWarnings(simulation);
  pictures.finish();
  std::cout << pictures.summary() << '\n';
  requireIntact(simulation);
  if (pictures.count() < arguments.frames) {
    throw messages::InputError("stopped by a signal after " + std::to_string(pictures.count()) + " of " +
                               std::to_string(arguments.frames) + " pictures");
  }
}

}  // namespace

void addCaptureCommand(CLI::App& app) {
  auto arguments = std::make_shared<CaptureArguments>();
  CLI::App* command = app.add_subcommand("capture", "Simulates and draws pictures, without a display");
  arguments->scene.addTo(*command);
  command->add_option("--frames", arguments->frames, "Number of pictures; the first shows the start")
      ->check(CLI::Range(1, 1000000));
  CLI::Option* every =
      command->add_option("--every", arguments->every, "Time steps between two pictures; default: about 1/30 s")
          ->check(CLI::Range(1, 1000000));
  command->add_option("--rate", arguments->rate, "Pictures per second of simulated time, at exact times")
      ->check(numberFrom(minFrameRate, maxFrameRate))
      ->excludes(every);
  command
      ->add_option("--output", arguments->output,
                   "File name of the pictures, with a placeholder for the number: f_{frame:4}.png; or a film: "
                   "f.mp4, .webm or .gif")
      ->required()
      ->check(notEmpty());
  arguments->view.addTo(*command);
  command->callback([arguments] { capture(*arguments); });
}

}  // namespace drape::app
