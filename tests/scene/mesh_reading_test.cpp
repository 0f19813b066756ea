#include "scene/mesh_reading.hpp"

#include "garment_shapes.hpp"
#include "scene/scene.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace drape::scene {
namespace {

/// Tests with files that are opened as a user does.
class MeshReadingTest : public ::testing::Test {
 protected:
  MeshReadingTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~MeshReadingTest() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::shared_ptr<const Scene> open(const sim::ClothMesh& mesh, const std::vector<std::string>& settings = {}) const {
    const SceneDescription description = openScene(write("mesh.obj", testing::objText(mesh)));
    settings::Settings inForce = description.settings;
    for (const std::string& setting : settings) {
      settings::assignSettingExpression(inForce, setting);
    }
    return buildScene(description, inForce);
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

bool offers(const MeshReading& reading, const std::string& key, const std::string& value) {
  return std::any_of(reading.alternatives.begin(), reading.alternatives.end(),
                     [&](const ReadingAlternative& each) { return each.key == key && each.value == value; });
}

int pinCount(const Scene& scene) {
  return static_cast<int>(std::count(scene.model->pinned.begin(), scene.model->pinned.end(), true));
}

TEST_F(MeshReadingTest, ShirtsInAnyUnitAndTurnOpenAlike) {
  const sim::ClothMesh shirt = testing::shirt({});
  for (const auto& [unit, perMetre] : {std::pair("m", 1.0), std::pair("dm", 10.0), std::pair("cm", 100.0),
                                       std::pair("mm", 1000.0), std::pair("inch", 1.0 / 0.0254)}) {
    for (const bool zUp : {false, true}) {
      const auto scene = open(testing::scaled(zUp ? testing::withZUp(shirt) : shirt, perMetre));
      ASSERT_TRUE(scene->reading.has_value());
      EXPECT_EQ(scene->reading->unit, unit);
      EXPECT_EQ(scene->reading->up, zUp ? "z" : "y") << unit;
      EXPECT_NEAR(scene->summary.size[1], 0.7, 0.03) << unit;
      EXPECT_NEAR(scene->reading->size[1], scene->summary.size[1], 1e-12);
      EXPECT_TRUE(isGuess(scene->reading->unitReason) && isGuess(scene->reading->upReason));
      EXPECT_GT(pinCount(*scene), 5);
      EXPECT_FALSE(scene->pinAdvice.has_value());
      EXPECT_LT(scene->model->totalMass(), 0.5) << "a shirt, and no tent";
    }
  }
}

TEST_F(MeshReadingTest, AGuessGivesTheSamePositionsAsTheWord) {
  const sim::ClothMesh mesh = testing::scaled(testing::withZUp(testing::tube(0.6, 0.3, 0.14, 0.8)), 100.0);
  const auto guessed = open(mesh);
  const auto said = open(mesh, {"unit=cm", "up=z"});
  EXPECT_EQ(guessed->model->restPositions, said->model->restPositions);
  EXPECT_EQ(guessed->model->pinned, said->model->pinned);
  EXPECT_EQ(guessed->renderMesh.uvs, said->renderMesh.uvs) << "made-up texture coordinates are metres too";
  EXPECT_FALSE(isGuess(said->reading->unitReason) || isGuess(said->reading->upReason));
  EXPECT_FALSE(said->reading->needsReview());
}

TEST_F(MeshReadingTest, TheLineTellsUnitAxisAndHeightAndOffersOthers) {
  const auto scene = open(testing::scaled(testing::withZUp(testing::shirt({})), 100.0));
  EXPECT_TRUE(inWords(*scene->reading).english().starts_with("Read as centimetres, z up: 0.7"))
      << inWords(*scene->reading);
  EXPECT_TRUE(scene->reading->needsReview());
  EXPECT_TRUE(offers(*scene->reading, "unit", "m"));
  EXPECT_TRUE(offers(*scene->reading, "unit", "inch"));
  EXPECT_TRUE(offers(*scene->reading, "up", "y"));
  EXPECT_FALSE(offers(*scene->reading, "unit", "cm")) << "what it was read as";
}

TEST_F(MeshReadingTest, AFactorIsTakenAsItIs) {
  const auto scene = open(testing::tube(3.0, 1.0, 1.0, 1.0), {"unit=0.3048", "up=y"});
  EXPECT_NEAR(scene->summary.size[1], 3.0 * 0.3048, 1e-6);
  EXPECT_EQ(inWords(*scene->reading), "Read as units of 0.3048 m, y up: 0.91 m tall.");
}

TEST(MeshReading, WhatTheFormatPrescribesIsNotGuessed) {
  settings::Settings::Mesh settings;
  settings.unit = "auto";
  settings.up = "auto";
  io::ImportedMesh mesh;
  mesh.cloth = testing::withZUp(testing::shirt({}));
  mesh.summary.size = {0.7, 0.2, 0.7};
  mesh.format = {1.0, 'y'};
  const MeshReading usual = readUpright(settings, mesh);
  EXPECT_EQ(usual.unit, "m");
  EXPECT_EQ(usual.up, "y");
  EXPECT_FALSE(isGuess(usual.unitReason) || isGuess(usual.upReason) || usual.needsReview());
  mesh.summary.size = {70.0, 20.0, 70.0};
  const MeshReading large = readUpright(settings, mesh);
  EXPECT_EQ(large.unit, "m");
  EXPECT_TRUE(offers(large, "unit", "cm")) << "a shirt of 70 m is told all the same";
  mesh.format = {0.3048, 'z'};
  EXPECT_EQ(readUpright(settings, mesh).unit, "foot");
}

TEST_F(MeshReadingTest, EveryAxisCanBeSaidToPointUp) {
  // A vertex above the others along each axis must end on top.
  for (const auto& [up, apex] :
       {std::pair("x", Vec3(2, 0, 0)), std::pair("y", Vec3(0, 2, 0)), std::pair("z", Vec3(0, 0, 2)),
        std::pair("-y", Vec3(0, -2, 0)), std::pair("-z", Vec3(0, 0, -2))}) {
    sim::ClothMesh mesh;
    mesh.positions = {apex, Vec3(0.3, 0.1, 0.2), Vec3(-0.1, 0.3, -0.2)};
    mesh.triangles = {{0, 1, 2}};
    const auto scene = open(mesh, {"unit=m", std::string("up=") + up});
    EXPECT_NEAR((scene->start.positions[0] - Vec3(0.0, 2.0, 0.0)).norm(), 0.0, 1e-9) << up;
    const Vec3 a = scene->start.positions[1] - scene->start.positions[0];
    const Vec3 b = scene->start.positions[2] - scene->start.positions[0];
    const Vec3 before = (mesh.positions[1] - mesh.positions[0]).cross(mesh.positions[2] - mesh.positions[0]);
    EXPECT_NEAR(a.cross(b).norm(), before.norm(), 1e-6) << "turned, and not mirrored or bent";
    EXPECT_NEAR(a.dot(b), (mesh.positions[1] - apex).dot(mesh.positions[2] - apex), 1e-6);
  }
}

TEST_F(MeshReadingTest, FlatSheetsHangByTwoCornersAndMove) {
  for (const int along : {1, 2}) {
    const auto scene = open(testing::sheet(0, along, 100.0, 100.0, 33));
    EXPECT_EQ(scene->reading->unit, "cm");
    EXPECT_EQ(pinCount(*scene), 2);
    EXPECT_FALSE(scene->pinAdvice.has_value());
  }
}

TEST_F(MeshReadingTest, PinsThatHoldAllOrNothingAreTold) {
  const sim::ClothMesh level = testing::sheet(0, 2, 1.0, 1.0, 33);
  const auto all = open(level, {"pins=top"});
  EXPECT_EQ(pinCount(*all), 1089);
  ASSERT_TRUE(all->pinAdvice.has_value());
  EXPECT_NE(all->pinAdvice->text.english().find("All 1089 vertices are pinned"), std::string::npos)
      << all->pinAdvice->text;
  EXPECT_EQ(all->pinAdvice->key + "=" + all->pinAdvice->value, "pins=shape");
  const auto none = open(level, {"pins=none"});
  ASSERT_TRUE(none->pinAdvice.has_value());
  EXPECT_NE(none->pinAdvice->text.english().find("Nothing is pinned"), std::string::npos);
  EXPECT_FALSE(open(level)->pinAdvice.has_value());
}

TEST_F(MeshReadingTest, FrozenClothIsToldAsTheCauseSincePinsWouldNotHelp) {
  for (const char* pins : {"scene", "none", "shape"}) {
    const SceneDescription frozen =
        openScene(write("frozen.toml", "[cloth]\ngrid = \"vertical\"\nfrozen = true\n" +
                                           ("[settings]\npins = \"" + std::string(pins)) + "\"\n"));
    const auto built = buildScene(frozen, frozen.settings);
    ASSERT_TRUE(built->pinAdvice.has_value());
    EXPECT_NE(built->pinAdvice->text.english().find("Remove frozen = true"), std::string::npos);
    EXPECT_EQ(built->pinAdvice->key, "");
  }
}

TEST_F(MeshReadingTest, AScenesMeshIsInMetresWithYUpUnlessItSaysOtherwise) {
  write("mesh.obj", testing::objText(testing::scaled(testing::withZUp(testing::shirt({})), 100.0)));
  const SceneDescription plain = openScene(write("plain.toml", "[cloth]\nmesh = \"mesh.obj\"\n"));
  const auto metres = buildScene(plain, plain.settings);
  EXPECT_EQ(metres->reading->metresPerUnit, 1.0);
  EXPECT_EQ(metres->reading->up, "y");
  EXPECT_TRUE(metres->reading->needsReview()) << "a shirt of 70 m is told";
  EXPECT_TRUE(offers(*metres->reading, "unit", "cm"));
  const SceneDescription guess =
      openScene(write("guess.toml", "[cloth]\nmesh = \"mesh.obj\"\n[settings]\nunit = \"auto\"\nup = \"auto\"\n"));
  const auto guessed = buildScene(guess, guess.settings);
  EXPECT_EQ(guessed->reading->unit, "cm");
  EXPECT_EQ(guessed->reading->up, "z");
}

TEST_F(MeshReadingTest, BuiltInMeshesAreNotAskedAbout) {
  const SceneDescription skirt = openScene("skirt");
  EXPECT_EQ(skirt.settings.mesh.unit, "m");
  EXPECT_EQ(skirt.settings.mesh.up, "y");
  EXPECT_EQ(skirt.settings.mesh.pins, "scene");
  EXPECT_FALSE(buildScene(skirt, skirt.settings)->reading.has_value());
}

TEST_F(MeshReadingTest, PinsOfASceneThatHoldNothingAreToldWithTheirLine) {
  const SceneDescription scene = openScene(
      write("mine.toml", "[cloth]\ngrid = \"vertical\"\n[pins]\nboxes = [{ min = [5, 5, 5], max = [6, 6, 6] }]\n"));
  const auto built = buildScene(scene, scene.settings);
  ASSERT_TRUE(built->pinAdvice.has_value());
  EXPECT_NE(built->pinAdvice->text.english().find("mine.toml:3: [pins] contains no vertex"), std::string::npos)
      << built->pinAdvice->text;
  const SceneDescription empty =
      openScene(write("empty.toml", "[cloth]\ngrid = \"vertical\"\n[pins]\nvertices = []\n"));
  EXPECT_TRUE(buildScene(empty, empty.settings)->pinAdvice.has_value()) << "an empty list too";
}

}  // namespace
}  // namespace drape::scene
