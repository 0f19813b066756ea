// Compares every built-in scene, half a second after its start or at a more interesting time, with a checked picture.
// Accept an intended change with scripts/update-pictures, and check the new pictures before you commit them.

#include "compare_images.hpp"
#include "fields/shown_field.hpp"
#include "render/camera.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "session/simulation.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
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
  static const std::map<std::string, double> others{{"cape", 1.5}, {"skater", 1.6}};
  const auto found = others.find(scene);
  return found == others.end() ? usually : found->second;
}

void PrintTo(const PictureCase& picture, std::ostream* stream) {
  *stream << picture.name;
}

std::vector<PictureCase> pictureCases() {
  std::vector<PictureCase> cases;
  for (const scene::SceneInfo& scene : scene::sceneList()) {
    cases.push_back({scene.name, scene.name, {}, 0.0, timeOf(scene.name)});
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

session::Snapshot simulate(const PictureCase& picture) {
  const scene::SceneDescription description = scene::openScene(picture.scene);
  settings::Settings settings = description.settings;
  for (const std::string& expression : picture.settings) {
    settings::assignSettingExpression(settings, expression);
  }
  session::Simulation simulation(scene::buildScene(description, settings));
  const auto steps = std::lround(picture.time / settings.step.timeStep);
  for (long step = 0; step < steps; ++step) {
    simulation.step();
  }
  session::Snapshot snapshot;
  simulation.capture(snapshot);
  return snapshot;
}

render::Image draw(const session::Snapshot& snapshot, double yaw) {
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
std::string keepEvidence(const PictureCase& picture, const render::Image& golden, const render::Image& actual) {
  const std::filesystem::path folder = DRAPE_ACTUAL_PICTURES;
  std::filesystem::create_directories(folder);
  const std::filesystem::path drawn = folder / (picture.name + ".png");
  const std::filesystem::path difference = folder / (picture.name + "_difference.png");
  render::writePng(actual, drawn);
  render::writePng(render::differencePicture(golden, actual, stepOfColour), difference);
  return "drawn:      " + drawn.string() + "\ndifference: " + difference.string() +
         "\nIf the change is meant: scripts/update-pictures";
}

class PictureTest : public testing::TestWithParam<PictureCase> {};

TEST_P(PictureTest, LooksAsBefore) {
  const PictureCase& picture = GetParam();
  const render::Image actual = draw(simulate(picture), picture.yaw);
  const std::filesystem::path file = std::filesystem::path(DRAPE_GOLDEN_PICTURES) / (picture.name + ".png");
  if (std::getenv("DRAPE_UPDATE_PICTURES") != nullptr) {
    render::writePng(actual, file);
    GTEST_SKIP() << "written: " << file;
  }
  ASSERT_TRUE(std::filesystem::exists(file)) << "no picture to compare with; make it with scripts/update-pictures";
  const render::Image golden = render::readPng(file);
  const render::ImageDifference difference = render::compareImages(golden, actual, stepOfColour);
  const bool alike = difference.sameSize && difference.pixels <= pixelsForgiven;
  EXPECT_TRUE(alike) << difference.pixels << " pixels differ, by up to " << difference.largest << "\n"
                     << keepEvidence(picture, golden, actual);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PictureTest, testing::ValuesIn(pictureCases()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace drape::app
