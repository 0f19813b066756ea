#include "scene/scene_parts.hpp"

#include "messages/error.hpp"
#include "scene/framing.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace drape::scene {
namespace {

/// Mesh and scene files in a separate folder. Lengths in centimetres.
class PartsOfAScene : public ::testing::Test {
 protected:
  PartsOfAScene() : folder_(std::filesystem::temp_directory_path() / ("drape-parts-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream(file("shawl.obj")) << "v -40 150 0\nv 40 150 0\nv 40 90 1\nv -40 90 0\nf 1 2 3\nf 1 3 4\n";
    std::ofstream(file("torso.obj")) << "v -10 0 -30\nv 10 0 -30\nv 0 120 -30\nv 0 0 -50\n"
                                        "f 1 2 3\nf 2 4 3\nf 4 1 3\nf 1 4 2\n";
    std::ofstream(file("rail.toml")) << "[cloth]\ngrid = \"vertical\"\nposition = [0, 1, 0]\n"
                                        "[pins]\nedges = [\"top\"]\n"
                                        "[[bodies]]\nname = \"torso\"\nshape = \"sphere\"\nradius = 0.1\n";
  }
  ~PartsOfAScene() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(PartsOfAScene, AGarmentMeetsABodyThatIsReadInTheSameUnit) {
  const SceneDescription description = openParts({.cloth = file("shawl.obj"), .bodies = {file("torso.obj")}});
  settings::Settings settings = description.settings;
  settings::assignSettingText(settings, settings::requireSetting("unit"), "cm");
  const auto scene = buildScene(description, settings);
  ASSERT_EQ(description.bodies.size(), 1U);
  EXPECT_EQ(scene->bodies->front().name, "torso");
  const auto& mesh = std::get<std::shared_ptr<const sim::contact::MeshShape>>(scene->bodies->front().shape);
  EXPECT_NEAR(sim::boundsOf(mesh->positions).sizes().y(), 1.2, 1e-6) << "[m]";
  EXPECT_NEAR(sim::boundsOf(scene->start.positions).sizes().y(), 0.6, 1e-6) << "[m]";
  EXPECT_EQ(scene->groundHeight, 0.0) << "the body stands on it";
}

TEST_F(PartsOfAScene, ABodyIsTurnedUprightWithTheCloth) {
  const SceneDescription description = openParts({.cloth = file("shawl.obj"), .bodies = {file("torso.obj")}});
  settings::Settings settings = description.settings;
  settings::assignSettingText(settings, settings::requireSetting("up"), "z");
  const auto scene = buildScene(description, settings);
  const sim::contact::Pose pose = sim::contact::poseAt(scene->bodies->front().motion, 0.0);
  EXPECT_NEAR((pose.toWorld(Vec3(1.0, 2.0, 3.0)) - Vec3(1.0, 3.0, -2.0)).norm(), 0.0, 1e-12);
}

TEST_F(PartsOfAScene, AMeshJoinsTheBodiesOfAScene) {
  const SceneDescription description = openParts({.scene = file("rail.toml"), .bodies = {file("torso.obj")}});
  EXPECT_TRUE(std::holds_alternative<GridSource>(description.cloth().source)) << "the scene keeps its cloth";
  ASSERT_EQ(description.bodies.size(), 2U);
  EXPECT_EQ(description.bodies[1].body.name, "torso 2") << "no two bodies have one name";
}

TEST_F(PartsOfAScene, AMeshTakesThePlaceOfAScenesCloth) {
  const SceneDescription description = openParts({.scene = file("rail.toml"), .cloth = file("shawl.obj")});
  EXPECT_EQ(std::get<MeshFileSource>(description.cloth().source).path, file("shawl.obj"));
  EXPECT_TRUE(description.cloth().pins.at(0).edges.empty()) << "they belong to a grid";
  EXPECT_EQ(description.bodies.size(), 1U) << "the scene keeps its bodies";
  EXPECT_NE(buildScene(description, description.settings), nullptr);
}

/// Whether a picture of 16 x 9 shows a point.
bool isVisible(const Vec3& point, const CameraPose& camera) {
  const CameraBasis basis = basisOf(camera);
  const Vec3 from = point - camera.position;
  const double half = -from.dot(basis.back) * tanHalfAngle(camera);  // of the height of the picture there
  return half > 0.0 && std::abs(from.dot(basis.up)) < half && std::abs(from.dot(basis.right)) < half * 16.0 / 9.0;
}

TEST_F(PartsOfAScene, TheCameraShowsTheWholeBodyThatIsToWearTheGarment) {
  SceneParts parts{.cloth = file("shawl.obj"), .bodies = {file("torso.obj")}, .dressed = true};
  parts.bodyReadings = {{"cm", "y"}};
  const SceneDescription description = openParts(parts);
  const auto scene = buildScene(description, description.settings);
  for (const Vec3& point : {Vec3(-0.1, 0.0, -0.3), Vec3(0.1, 0.0, -0.3), Vec3(0.0, 1.2, -0.3), Vec3(0.0, 0.0, -0.5)}) {
    EXPECT_TRUE(isVisible(point, scene->camera)) << point.transpose();
  }
}

TEST_F(PartsOfAScene, OnlyMeshesAreBodiesAndCloth) {
  EXPECT_THROW(static_cast<void>(openParts({.cloth = file("shawl.obj"), .bodies = {file("rail.toml")}})),
               messages::InputError);
  EXPECT_THROW(static_cast<void>(openParts({.scene = file("rail.toml"), .cloth = file("rail.toml")})),
               messages::InputError);
  EXPECT_THROW(static_cast<void>(openParts({.cloth = file("no-such.obj")})), messages::InputError);
}

}  // namespace
}  // namespace drape::scene
