#include "animation_files.hpp"
#include "messages/error.hpp"
#include "scene/placements.hpp"
#include "scene/scene.hpp"
#include "sim/contact/bodies/world.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace drape::scene {
namespace {

/// The scene file of a body with these keys.
SceneDescription openFigure(const std::string& keys) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "drape_figure.toml";
  std::ofstream(file) << "[cloth]\ngrid = \"vertical\"\n[[bodies]]\nname = \"figure\"\n"
                      << keys << "\n[settings]\ngrid.resolution = 5\n";
  SceneDescription description = openScene(file.string());
  std::filesystem::remove(file);
  return description;
}

std::string problemOf(const std::string& keys) {
  try {
    (void)openFigure(keys);
  } catch (const messages::InputError& error) {
    return error.what();
  }
  return "";
}

const sim::contact::MeshShape& meshOf(const Scene& scene) {
  return *std::get<std::shared_ptr<const sim::contact::MeshShape>>(scene.bodies->at(0).shape);
}

TEST(FigureScenes, buildABodyThatDeforms) {
  const SceneDescription description = openFigure("shape = \"figure\"\nmotion = \"squat\"\nheight = 1.6");
  ASSERT_TRUE(description.bodies.at(0).figure);
  EXPECT_EQ(description.bodies[0].figure->motion->name, "squat");
  const auto scene = buildScene(description, description.settings);
  const sim::contact::MeshShape& mesh = meshOf(*scene);
  ASSERT_TRUE(mesh.deforms());
  std::vector<Vec3> positions;
  mesh.deformation->positionsAt(0.0, positions);
  EXPECT_EQ(positions, mesh.positions);
  mesh.deformation->positionsAt(1.5, positions);  // the deepest point
  double highest = 0.0;
  for (const Vec3& position : positions) {
    highest = std::max(highest, position.y());
  }
  EXPECT_LT(highest, 1.35);
  EXPECT_GT(highest, 1.0);
}

TEST(FigureScenes, moveTheFigureInTheWorldOfBodies) {
  const SceneDescription description = openFigure("shape = \"figure\"\nmotion = \"walk\"");
  const auto scene = buildScene(description, description.settings);
  sim::contact::BodyWorld world(scene->bodies, 0.0);
  EXPECT_TRUE(world.isDeforming(0));
  world.advance(0.9, 0.1);
  std::vector<Vec3> expected;
  meshOf(*scene).deformation->positionsAt(1.0, expected);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), world.vertices(0).begin(), world.vertices(0).end()));
}

TEST(FigureScenes, nameTheMotionsAndTheRangesInErrors) {
  const std::string unknown = problemOf("shape = \"figure\"\nmotion = \"fly\"");
  EXPECT_NE(unknown.find("drape_figure.toml:3"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("bodies.motion must be one of rest, t_pose,"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("dance, not \"fly\""), std::string::npos) << unknown;
  EXPECT_NE(problemOf("shape = \"figure\"\nwaist = 3").find("waist"), std::string::npos);
  EXPECT_NE(problemOf("shape = \"figure\"\nspeed = 0").find("speed"), std::string::npos);
  EXPECT_NE(problemOf("shape = \"figure\"\nradius = 1").find("radius"), std::string::npos);
  EXPECT_NE(problemOf("shape = \"sphere\"\nmotion = \"walk\"").find("motion"), std::string::npos);
}

TEST(FigureScenes, moveABodyByAnotherClipOfItsFile) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "drape_bar.gltf";
  std::ofstream(file) << io::BarFile().text();
  const SceneDescription opened =
      openFigure("shape = \"mesh\"\nmesh = \"" + file.string() + "\"\nanimation = { clip = \"bend\", rate = 2 }");
  const auto bends = buildScene(opened, opened.settings);
  EXPECT_EQ(bends->clips, (std::vector<std::vector<io::ClipFacts>>{{{"bend", 2.0}, {"still", 2.0}}}));
  EXPECT_NE(meshOf(*bends).frames.front(), meshOf(*bends).frames.back());

  Placements choices = placementsOf(opened);
  EXPECT_EQ(choices, writtenPlacementsOf(opened));
  choices.clips = {"still"};
  const SceneDescription chosen = withPlacements(opened, choices);
  EXPECT_NE(placementsOf(chosen), writtenPlacementsOf(chosen)) << "it is a change of the user";
  const auto stands = buildScene(chosen, chosen.settings);
  EXPECT_EQ(meshOf(*stands).frames.front(), meshOf(*stands).frames.back());
  EXPECT_EQ(withPlacements(chosen, writtenPlacementsOf(chosen)).bodies[0].animation->clip, "bend");
  choices.clips.clear();
  EXPECT_EQ(withPlacements(chosen, choices).bodies[0].animation->clip, "still") << "it keeps its clip";
  std::filesystem::remove(file);
}

TEST(FigureScenes, nameTheFileOfAnAnimationThatCannotBeRead) {
  const SceneDescription description =
      openFigure("shape = \"mesh\"\nmesh = \"nowhere.glb\"\nanimation = { clip = \"walk\", rate = 30 }");
  ASSERT_TRUE(description.bodies.at(0).animation);
  EXPECT_EQ(description.bodies[0].animation->clip, "walk");
  try {
    (void)buildScene(description, description.settings);
    ADD_FAILURE() << "no InputError";
  } catch (const messages::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere.glb: no such file"), std::string::npos) << error.what();
  }
  EXPECT_NE(problemOf("shape = \"mesh\"\nmesh = \"a.glb\"\nanimation = { rate = 0 }").find("rate"), std::string::npos);
  EXPECT_NE(problemOf("shape = \"mesh\"\nmesh = \"a.glb\"\nanimation = { blend = 61 }").find("blend"),
            std::string::npos);
  EXPECT_NE(problemOf("shape = \"mesh\"\nmesh = \"a_#.obj\"\nframes = { last = 3 }\nanimation = { rate = 30 }")
                .find("either frames or an animation"),
            std::string::npos);
}

}  // namespace
}  // namespace drape::scene
