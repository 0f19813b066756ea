#include "messages/error.hpp"
#include "scene/scene_file.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace drape::scene {
namespace {

constexpr const char* twoCarriers = R"(
[cloth]
grid = "vertical"

[[pins]]
edges = ["left"]
body = "left"

[[pins]]
edges = ["right", "top"]
body = "right"

[[pins]]
vertices = [12]

[[bodies]]
name = "left"
shape = "sphere"

[[bodies]]
name = "right"
shape = "sphere"

[settings]
grid.resolution = 5
)";

std::vector<int> pinsOf(const sim::contact::Body& body) {
  std::vector<int> vertices;
  for (const sim::contact::CarriedPin& pin : body.pins) {
    vertices.push_back(pin.vertex);
  }
  return vertices;
}

TEST(CarriedPins, belongToTheBodyOfTheFirstTableThatSelectsThem) {
  const auto file = std::filesystem::temp_directory_path() / "drape_two_carriers.toml";
  std::ofstream(file) << twoCarriers;
  const SceneDescription description = openScene(file.string());
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(pinsOf(scene->bodies->at(0)), (std::vector<int>{0, 5, 10, 15, 20}));
  EXPECT_EQ(pinsOf(scene->bodies->at(1)), (std::vector<int>{1, 2, 3, 4, 9, 14, 19, 24}));
  EXPECT_TRUE(scene->model->pinned[12]) << "fixed in space";
  EXPECT_EQ(std::count(scene->model->pinned.begin(), scene->model->pinned.end(), true), 14);
  std::filesystem::remove(file);
}

std::string refusalOfPins(const std::string& pins) {
  try {
    (void)parseScene("[cloth]\ngrid = \"vertical\"\n[pins]\ncorners = [\"top_left\"]\n" + pins +
                         "\n[[bodies]]\nname = \"hand\"\nshape = \"sphere\"\n",
                     "pins", "pins.toml", "/");
  } catch (const messages::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PinsWithKeyframes, areRefusedWithPlaceAndReason) {
  EXPECT_EQ(refusalOfPins("keyframes = [{ time = 0 }, { time = 1, position = [0, 0.2, 0] }]"), "");
  EXPECT_EQ(refusalOfPins("keyframes = [{ time = 0 }]\nbody = \"hand\""),
            "pins.toml:3: pins follow either a body or keyframes, not both");
  EXPECT_EQ(refusalOfPins("loop = true"), "pins.toml:3: loop needs keyframes");
  EXPECT_NE(refusalOfPins("keyframes = [{ time = 1 }, { time = 1 }]").find("the times of the keyframes must ascend"),
            std::string::npos);
  EXPECT_NE(refusalOfPins("keyframes = [{ position = [0, 1, 0] }]").find("a keyframe needs a time"), std::string::npos);
}

TEST(PinsWithKeyframes, moveAllSelectedVerticesOfTheirTable) {
  const SceneDescription description = parseScene(R"(
[cloth]
grid = "vertical"
[[pins]]
edges = ["left"]
keyframes = [{ time = 0 }, { time = 2, position = [0.1, 0, 0], rotation = [0, 0, 90] }]
loop = true
[[pins]]
edges = ["top"]
[settings]
grid.resolution = 5
)",
                                                  "pins", "pins.toml", "/");
  const auto scene = buildScene(description, description.settings);
  ASSERT_EQ(scene->pinPaths.size(), 1U);
  const PinPath& path = scene->pinPaths.front();
  EXPECT_EQ(path.vertices, (std::vector<int>{0, 5, 10, 15, 20}));
  EXPECT_NEAR((path.centre - scene->start.positions[10]).norm(), 0.0, 1e-12);
  EXPECT_TRUE(path.motion.loop);
  EXPECT_EQ(std::count(scene->model->pinned.begin(), scene->model->pinned.end(), true), 9);
}

}  // namespace
}  // namespace drape::scene
