#include "app/command_line.hpp"
#include "app/headless/commands.hpp"
#include "app/headless/frame_name.hpp"
#include "app/headless/intact.hpp"
#include "app/headless/picture_maker.hpp"
#include "app/headless/solver_notes.hpp"
#include "app/output_file.hpp"
#include "app/progress_line.hpp"
#include "messages/error.hpp"
#include "session/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

namespace drape::app {
namespace {

struct CaptureArguments {
  SceneArguments scene;
  int frames = 1;
  int every = 0;
  std::string output;
  std::vector<int> resolution{1280, 720};
  std::vector<double> cameraPosition;
  std::vector<double> focalPoint;
  bool ui = false;
};

/// Without --every the time between frames is close to this, in whole steps [s].
constexpr double usualFrame = 1.0 / 30.0;

scene::CameraPose poseFor(const CaptureArguments& arguments, scene::CameraPose pose) {
  const auto take = [](const std::vector<double>& numbers, Vec3& point) {
    if (!numbers.empty()) {
      point = Vec3(numbers[0], numbers[1], numbers[2]);
    }
  };
  take(arguments.cameraPosition, pose.position);
  take(arguments.focalPoint, pose.focalPoint);
  if (!((pose.position - pose.focalPoint).norm() > 0.0)) {
    throw messages::UsageError("--camera-position and --camera-focal-point must be two different points");
  }
  return pose;
}

void capture(const CaptureArguments& arguments) {
  const FramePattern pattern(arguments.output, arguments.frames);
  session::Simulation simulation(arguments.scene.load());
  printSolverWarnings(simulation.settings(), simulation.model());
  // Before the simulation, so that an error shows at once.
  if (const auto folder = std::filesystem::path(pattern.name(0)).parent_path(); !folder.empty()) {
    makeFolder(folder);
  }
  const double timeStep = simulation.settings().step.timeStep;
  const int every =
      arguments.every > 0 ? arguments.every : std::max(1, static_cast<int>(std::lround(usualFrame / timeStep)));
  PictureMaker pictures(arguments.resolution[0], arguments.resolution[1], arguments.ui,
                        simulation.settings().view.fontScale, poseFor(arguments, simulation.scene().camera));
  {
    ProgressLine progress;
    for (int frame = 0; frame < arguments.frames; ++frame) {
      for (int i = 0; frame > 0 && i < every && !simulation.blewUp(); ++i) {
        simulation.step();
      }
      render::writePng(pictures.draw(simulation), pattern.name(frame));
      progress.show("capturing", frame + 1, arguments.frames);
    }
  }
  if (!simulation.message().empty() && !simulation.blewUp()) {
    std::cerr << "warning: " << simulation.message() << '\n';
  }
  std::cout << arguments.frames << (arguments.frames == 1 ? " picture: " : " pictures: ") << pattern.name(0);
  if (arguments.frames > 1) {
    std::cout << " to " << pattern.name(arguments.frames - 1);
  }
  std::cout << '\n';
  requireIntact(simulation);
}

}  // namespace

void addCaptureCommand(CLI::App& app) {
  constexpr int maxPixels = 16384;
  constexpr double farAway = 1e6;
  auto arguments = std::make_shared<CaptureArguments>();
  CLI::App* command = app.add_subcommand("capture", "Simulates and draws pictures, without a display");
  arguments->scene.addTo(*command);
  command->add_option("--frames", arguments->frames, "Number of pictures; the first shows the start")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--every", arguments->every, "Time steps between two pictures; default: about 1/30 s")
      ->check(CLI::Range(1, 1000000));
  command
      ->add_option("--output", arguments->output,
                   "File name of the pictures, with a placeholder for the number: f_{frame:4}.png")
      ->required()
      ->check(notEmpty());
  command->add_option("--resolution", arguments->resolution, "Width and height [pixels]")
      ->delimiter(',')
      ->expected(2)
      ->type_name("W,H")
      ->check(CLI::Range(16, maxPixels));
  command->add_option("--camera-position", arguments->cameraPosition, "Position of the camera [m]")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z")
      ->check(numberFrom(-farAway, farAway));
  command->add_option("--camera-focal-point", arguments->focalPoint, "Point at the centre of the view [m]")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z")
      ->check(numberFrom(-farAway, farAway));
  command->add_flag("--ui", arguments->ui, "Draw the panels too");
  command->callback([arguments] { capture(*arguments); });
}

}  // namespace drape::app
