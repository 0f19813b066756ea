#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>

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

}  // namespace
}  // namespace drape::scene
