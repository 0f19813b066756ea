#include "scene/mesh_placement.hpp"

#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::scene {
namespace {

TEST(MeshPlacement, undoesUnitAxesAndPlacement) {
  for (const char* up : {"x", "y", "z", "-y", "-z"}) {
    MeshPlacement placement;
    placement.metresPerUnit = 0.0254;
    placement.up = up;
    placement.pose.rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
    placement.pose.position = Vec3(0.1, -2, 5);
    const Vec3 inFile(30, -4, 11);
    EXPECT_LT((placement.toFile(placement.toScene(inFile)) - inFile).norm(), 1e-12) << up;
    // A direction is the difference of two points, without the unit.
    const Vec3 direction = placement.toScene(inFile + Vec3(0, 0, 1)) - placement.toScene(inFile);
    EXPECT_LT((placement.directionInFile(direction) / 0.0254 - Vec3(0, 0, 1)).norm(), 1e-12) << up;
  }
}

TEST(MeshPlacement, turnsTheUpAxisToY) {
  EXPECT_EQ(turnedUpright(Vec3(0, 0, 1), "z"), Vec3(0, 1, 0));
  EXPECT_EQ(turnedUpright(Vec3(1, 0, 0), "x"), Vec3(0, 1, 0));
  EXPECT_EQ(turnedUpright(Vec3(0, 0, -1), "-z"), Vec3(0, 1, 0));
  EXPECT_EQ(turnedUpright(Vec3(0, -1, 0), "-y"), Vec3(0, 1, 0));
}

TEST(MeshPlacement, leadsFromTheFileToTheStartOfEachBuiltInClothOfAFile) {
  int files = 0;
  for (const SceneInfo& info : sceneList()) {
    const SceneDescription description = openScene(info.name);
    const bool ofFiles = std::ranges::all_of(description.cloths, [](const ClothDescription& cloth) {
      return std::holds_alternative<MeshFileSource>(cloth.source);
    });
    if (!ofFiles) {
      continue;
    }
    const auto scene = buildScene(description, description.settings);
    for (const ClothPart& cloth : scene->cloths) {
      ++files;
      for (std::size_t v = 0; v < cloth.file->positions.size(); ++v) {
        ASSERT_GE(cloth.file->particle[v], 0);
        const Vec3& start = scene->start.positions[cloth.firstVertex + cloth.file->particle[v]];
        ASSERT_LT((cloth.placement.toScene(cloth.file->positions[v]) - start).norm(), 1e-6) << info.name;
      }
    }
  }
  EXPECT_GT(files, 1);
}

}  // namespace
}  // namespace drape::scene
