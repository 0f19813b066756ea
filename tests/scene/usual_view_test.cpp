#include "scene/framing.hpp"
#include "scene/scene_file.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

namespace drape::scene {
namespace {

CameraPose viewOf(const std::string& toml) {
  const SceneDescription description = parseScene(toml, "test", "test.toml", {});
  return buildScene(description, description.settings)->camera;
}

/// Whether a picture of the usual shape shows the point.
bool shows(const CameraPose& pose, const Vec3& point) {
  constexpr double aspect = 16.0 / 9.0;
  const CameraBasis basis = basisOf(pose);
  const Vec3 offset = point - pose.position;
  const double depth = -offset.dot(basis.back);
  const double height = depth * tanHalfAngle(pose);
  return depth > 0.0 && std::abs(offset.dot(basis.up)) < height && std::abs(offset.dot(basis.right)) < aspect * height;
}

const std::string freeSheet = "[cloth]\ngrid = \"horizontal\"\nposition = [0, 2, 0]\n";
const std::string pinnedSheet = freeSheet + "[pins]\nedges = [\"top\"]\n";

TEST(UsualView, showsTheGroundOntoWhichAFreeSheetFalls) {
  const CameraPose pose = viewOf(freeSheet);
  for (const double side : {-0.5, 0.5}) {
    EXPECT_TRUE(shows(pose, {side, 2.0, side}));
    EXPECT_TRUE(shows(pose, {side, 0.0, side}));
  }
}

TEST(UsualView, showsTheCloserPartOfAVeryLongFall) {
  const CameraPose pose = viewOf(freeSheet + "[ground]\nheight = -100\n");
  EXPECT_TRUE(shows(pose, {0.0, -3.0, 0.0}));
  EXPECT_FALSE(shows(pose, {0.0, -20.0, 0.0}));
}

TEST(UsualView, showsHowFarAPinnedSheetHangsDownAndNoMore) {
  const CameraPose pose = viewOf(pinnedSheet);
  EXPECT_TRUE(shows(pose, {0.0, 1.0, 0.0}));
  EXPECT_FALSE(shows(pose, {0.0, 0.0, 0.0}));
}

TEST(UsualView, staysAtClothWithoutPinsAndGround) {
  const CameraPose pose = viewOf(freeSheet + "[ground]\nsolid = false\n");
  EXPECT_TRUE(shows(pose, {0.5, 2.0, 0.5}));
  EXPECT_FALSE(shows(pose, {0.0, 0.0, 0.0}));
}

TEST(UsualView, showsBodiesBesideTheClothButNotRooms) {
  const CameraPose besideBall =
      viewOf(pinnedSheet + "[[bodies]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.3\nposition = [1.5, 2, 0]\n");
  EXPECT_TRUE(shows(besideBall, {1.8, 2.0, 0.0}));
  const CameraPose inRoom = viewOf(
      pinnedSheet + "[[bodies]]\nname = \"wall\"\nshape = \"box\"\nsize = [20, 3, 0.1]\nposition = [0, 0, -3]\n");
  EXPECT_FALSE(shows(inRoom, {9.0, 2.0, -3.0}));
}

TEST(UsualView, leavesTheCameraOfASceneAlone) {
  const CameraPose pose = viewOf(freeSheet + "[camera]\nposition = [5, 6, 7]\nfocal_point = [1, 2, 3]\n");
  EXPECT_EQ(pose.position, Vec3(5.0, 6.0, 7.0));
  EXPECT_EQ(pose.focalPoint, Vec3(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace drape::scene
