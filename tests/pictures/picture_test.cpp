// Compares every built-in scene, half a second after its start or at a more interesting time, with a checked picture.
// Scenes of a figure that moves are compared every half second.
// Accept an intended change with scripts/update-pictures, and check the new pictures before you commit them.

#include "compare_images.hpp"
#include "fields/shown_field.hpp"
#include "render/camera.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace drape::app {
namespace {

constexpr int width = 480;          // [pixels]
constexpr int height = 360;         // [pixels]
constexpr double usually = 0.5;     // default time of the picture after the start [s]
constexpr int stepOfColour = 1;     // a processor without fused multiply-add rounds a colour to its neighbour
constexpr int pixelsForgiven = 20;  // ... and sometimes resolves a sample of an outline differently

/// The contents of a picture.
struct PictureCase {
  std::string name;                   ///< of the file, without extension
  std::string scene;                  ///< a built-in scene
  std::vector<std::string> settings;  ///< "key=value"
  double yaw = 0.0;                   ///< rotation of the camera about its focal point, from the scene's view [rad]
  double time = usually;              ///< after the start [s]
};

/// The time for the picture of a built-in scene [s].
double timeOf(const std::string& scene) {
  return scene == "cape" ? 1.5 : usually;
}

/// The built-in scenes of a figure that moves.
const std::vector<std::string>& movingFigures() {
  static const std::vector<std::string> scenes{"walk", "dance", "skater"};
  return scenes;
}

void PrintTo(const PictureCase& picture, std::ostream* stream) {
  *stream << picture.name;
}

std::vector<PictureCase> pictureCases() {
  std::vector<PictureCase> cases;
  for (const scene::SceneInfo& scene : scene::sceneList()) {
    if (std::ranges::find(movingFigures(), scene.name) == movingFigures().end()) {
      cases.push_back({scene.name, scene.name, {}, 0.0, timeOf(scene.name)});
    }
  }
  cases.push_back({"grid_wireframe", "grid", {"view.wireframe=on"}, 0.0});
  cases.push_back({"sphere_65", "sphere", {"grid.resolution=65"}});
  cases.push_back({"sphere_129", "sphere", {"grid.resolution=129"}});
  cases.push_back({"sphere_curvature", "sphere", {"view.colour_map=bending"}, 0.0, 1.0});
  cases.push_back({"flag_speed", "flag", {"view.colour_map=speed", "view.wireframe=on"}});
  cases.push_back(
      {"grid_stretch_fixed", "grid", {"view.colour_map=strain_warp", "view.colour_low=90", "view.colour_high=130"}});
  cases.push_back({"flag_plain_from_behind", "flag", {"view.surface=plain", "view.ground=off"}, 2.6});
  cases.push_back({"grid_wrinkles", "grid", {"view.wrinkles=on", "view.surface=plain"}, 0.0, 0.8});
  return cases;
}

/// A built-in scene at its start. @param changes of the settings, each "key=value"
session::Simulation open(const std::string& scene, const std::vector<std::string>& changes) {
  const scene::SceneDescription description = scene::openScene(scene);
  settings::Settings settings = description.settings;
  for (const std::string& expression : changes) {
    settings::assignSettingExpression(settings, expression);
  }
  return session::Simulation(scene::buildScene(description, settings));
}

void advance(session::Simulation& simulation, double seconds) {
  const auto steps = std::lround(seconds / simulation.settings().step.timeStep);
  for (long step = 0; step < steps; ++step) {
    simulation.step();
  }
}

render::Image draw(const session::Simulation& simulation, double yaw) {
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  const render::OsmesaContext context;
  render::Renderer renderer;
  render::Camera camera(snapshot.scene->camera);
  camera.orbit(yaw, 0.0);
  fields::SnapshotFields fields;
  fields::FieldDisplay display;
  renderer.draw(snapshot, camera, width, height, {.field = &display.update(snapshot, fields)});
  return renderer.read();
}

/// Writes the picture and its difference; returns a message that names the files.
std::string keepEvidence(const std::string& name, const render::Image& golden, const render::Image& actual) {
  const std::filesystem::path folder = DRAPE_ACTUAL_PICTURES;
  std::filesystem::create_directories(folder);
  const std::filesystem::path drawn = folder / (name + ".png");
  const std::filesystem::path difference = folder / (name + "_difference.png");
  render::writePng(actual, drawn);
  render::writePng(render::differencePicture(golden, actual, stepOfColour), difference);
  return "drawn:      " + drawn.string() + "\ndifference: " + difference.string() +
         "\nIf the change is meant: scripts/update-pictures";
}

/// Compares a picture with the checked one, or replaces that one. @param name of the file, without extension
void compareOrUpdate(const std::string& name, const render::Image& actual) {
  const std::filesystem::path file = std::filesystem::path(DRAPE_GOLDEN_PICTURES) / (name + ".png");
  if (std::getenv("DRAPE_UPDATE_PICTURES") != nullptr) {
    render::writePng(actual, file);
    return;
  }
  ASSERT_TRUE(std::filesystem::exists(file)) << "no picture to compare with; make it with scripts/update-pictures";
  const render::Image golden = render::readPng(file);
  const render::ImageDifference difference = render::compareImages(golden, actual, stepOfColour);
  const bool alike = difference.sameSize && difference.pixels <= pixelsForgiven;
  EXPECT_TRUE(alike) << difference.pixels << " pixels differ, by up to " << difference.largest << "\n"
                     << keepEvidence(name, golden, actual);
}

class PictureTest : public testing::TestWithParam<PictureCase> {};

TEST_P(PictureTest, LooksAsBefore) {
  const PictureCase& picture = GetParam();
  session::Simulation simulation = open(picture.scene, picture.settings);
  advance(simulation, picture.time);
  compareOrUpdate(picture.name, draw(simulation, picture.yaw));
}

INSTANTIATE_TEST_SUITE_P(Scenes, PictureTest, testing::ValuesIn(pictureCases()),
                         [](const auto& parameter) { return parameter.param.name; });

class MovingFigureTest : public testing::TestWithParam<std::string> {};

TEST_P(MovingFigureTest, LooksAsBeforeEveryHalfSecond) {
  session::Simulation simulation = open(GetParam(), {});
  for (const char* time : {"500ms", "1000ms", "1500ms", "2000ms"}) {
    advance(simulation, usually);
    compareOrUpdate(GetParam() + "_" + time, draw(simulation, 0.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MovingFigureTest, testing::ValuesIn(movingFigures()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace drape::app
