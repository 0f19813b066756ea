#include "app/headless/view_arguments.hpp"

#include "app/command_line.hpp"
#include "messages/error.hpp"

#include <fmt/ranges.h>

namespace drape::app {
namespace {

scene::CameraPose poseFor(const ViewArguments& arguments, scene::CameraPose pose) {
  const auto take = [](const std::vector<double>& numbers, Vec3& point) {
    if (!numbers.empty()) {
      point = Vec3(numbers[0], numbers[1], numbers[2]);
    }
  };
  take(arguments.cameraPosition, pose.position);
  take(arguments.focalPoint, pose.focalPoint);
  pose.isOrthographic = pose.isOrthographic || arguments.orthographic;
  if (!((pose.position - pose.focalPoint).norm() > 0.0)) {
    throw messages::UsageError("--camera-position and --camera-focal-point must be two different points");
  }
  return pose;
}

}  // namespace

std::unique_ptr<PictureMaker> ViewArguments::makerFor(const session::Simulation& simulation) const {
  const render::Camera camera(poseFor(*this, simulation.scene().camera));
  return std::make_unique<PictureMaker>(resolution[0], resolution[1], ui, simulation.settings().view.fontScale, camera);
}

std::string ViewArguments::inWords() const {
  return fmt::format("resolution {}, camera {} {}, ui {}{}", resolution, cameraPosition, focalPoint, ui,
                     orthographic ? ", orthographic" : "");
}

void ViewArguments::addTo(CLI::App& app) {
  constexpr int maxPixels = 16384;
  constexpr double farAway = 1e6;
  app.add_option("--resolution", resolution, "Width and height [pixels]")
      ->delimiter(',')
      ->expected(2)
      ->type_name("W,H")
      ->check(CLI::Range(16, maxPixels));
  app.add_option("--camera-position", cameraPosition, "Position of the camera [m]")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z")
      ->check(numberFrom(-farAway, farAway));
  app.add_option("--camera-focal-point", focalPoint, "Point at the centre of the view [m]")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z")
      ->check(numberFrom(-farAway, farAway));
  app.add_flag("--orthographic", orthographic, "Draw without perspective, as much of the focal plane as with it");
  app.add_flag("--ui", ui, "Draw the panels too");
}

}  // namespace drape::app
