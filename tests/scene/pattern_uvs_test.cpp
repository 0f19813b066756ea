#include "scene/pattern_uvs.hpp"

#include "mesh_text_test.hpp"
#include "messages/error.hpp"
#include "scene/cloth_material.hpp"
#include "scene/scene.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>

namespace drape::scene {
namespace {

/// A vertical square in two triangles, with one texture coordinate for each corner.
constexpr const char* squareCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
constexpr const char* squareFaces = "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

class UvMesh : public MeshTextTest {
 protected:
  UvMesh() : MeshTextTest({"material.model=fabric"}) {}
};

std::string square(const char* uvs) {
  return std::string(squareCorners) + uvs + squareFaces;
}

/// The warp of a triangle, as the scene takes it.
Vec3 warpOf(const Scene& scene, std::size_t triangle) {
  return warpDirections(*scene.model, scene.cloths, scene.settings)[triangle];
}

TEST_F(UvMesh, GivesWarpAlongVHoweverThePatternLies) {
  // U runs up, V runs to the left; then the same mirrored as a whole, as a piece of folded cloth.
  const auto turned = build(square("vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"));
  const auto mirrored = build(square("vt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\n"));
  for (const std::size_t t : {0U, 1U}) {
    EXPECT_LT((warpOf(*turned, t) - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-6);
    EXPECT_LT((warpOf(*mirrored, t) - Vec3(1.0, 0.0, 0.0)).norm(), 1e-6);
  }
  EXPECT_EQ(warpInWords(turned->cloths, turned->settings), "along V of the UVs");
  settings::Settings vertical = turned->settings;
  settings::assignSettingExpression(vertical, "fabric.warp_from=vertical");
  settings::assignSettingExpression(vertical, "fabric.warp_angle=30");
  EXPECT_LT((warpDirections(*turned->model, turned->cloths, vertical)[0] - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(warpInWords(turned->cloths, vertical), "vertical, turned by 30 degrees");
}

TEST_F(UvMesh, ShearedPatternHasWarpWhereUIsConstant) {
  const auto scene = build(square("vt 0 0\nvt 1 0\nvt 1.5 1\nvt 0.5 1\n"), {"fabric.warp_from=uv"});
  EXPECT_LT((warpOf(*scene, 0) - Vec3(-0.5, 1.0, 0.0).normalized()).norm(), 1e-6);
}

TEST_F(UvMesh, ReachesTheFabricAndIsTurnedByTheAngle) {
  const char* uvs = "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n";
  const auto alongX = build(square(uvs));
  // The first side of the first triangle runs along x.
  EXPECT_NEAR(std::abs(alongX->model->fabric->shape.triangles[0].sides[0].x()), 1.0, 1e-6);
  const auto turned = build(square(uvs), {"fabric.warp_angle=90"});
  EXPECT_NEAR(turned->model->fabric->shape.triangles[0].sides[0].x(), 0.0, 1e-6);
}

TEST_F(UvMesh, RefusesDegenerateTextureWithNumberAndPlace) {
  const std::string flat = square("vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n");
  const std::string message = refusal(flat, {"fabric.warp_from=uv"});
  EXPECT_NE(message.find("give no area to 1 triangle (number 1)"), std::string::npos) << message;
  EXPECT_NE(message.find("use fabric.warp_from = vertical"), std::string::npos) << message;
  const auto scene = build(flat);
  EXPECT_LT((warpOf(*scene, 1) - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_NE(warpNote(scene->cloths.front().uvs, scene->settings)
                .english()
                .find("warp is vertical, because the texture coordinates"),
            std::string::npos);
}

TEST_F(UvMesh, RefusesATriangleThatIsTurnedOverWithinItsPiece) {
  // The fourth corner lies on the same side of the diagonal as the second.
  const std::string folded = square("vt 0 0\nvt 1 0\nvt 1 1\nvt 0.9 0.1\n");
  const std::string message = refusal(folded, {"fabric.warp_from=uv"});
  EXPECT_NE(message.find("mirror 1 triangle (number 1) against"), std::string::npos) << message;
  EXPECT_NE(warpNote(build(folded)->cloths, build(folded)->settings), "");
}

TEST_F(UvMesh, RefusesUvWithoutTextureAndSaysNothingInAuto) {
  const std::string bare = std::string(squareCorners) + "f 1 2 3\nf 1 3 4\n";
  EXPECT_NE(refusal(bare, {"fabric.warp_from=uv"}).find("no texture coordinates"), std::string::npos);
  const auto scene = build(bare);
  EXPECT_FALSE(scene->cloths.front().uvs.present());
  EXPECT_EQ(warpNote(scene->cloths.front().uvs, scene->settings), "");
}

TEST_F(UvMesh, IsNoPatternWhereTheTextureIsStretched) {
  const std::string wide = square("vt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\n");
  const auto scene = build(wide);
  EXPECT_NEAR(scene->cloths.front().uvs.distorted, 1.0, 1e-12);
  EXPECT_FALSE(warpsAlongUvs(scene->cloths.front().uvs, scene->settings));
  EXPECT_TRUE(warpsAlongUvs(scene->cloths.front().uvs, build(wide, {"fabric.warp_from=uv"})->settings))
      << "the user may know better";
}

TEST(BuiltInMeshes, arePatternsExceptTheCape) {
  for (const auto& [name, pattern] :
       {std::pair("tshirt", true), {"skirt", true}, {"poncho", true}, {"cape", false}, {"skater", false}}) {
    const SceneDescription description = [&, mesh = std::string(name)] {
      SceneDescription grid = openScene("grid");
      grid.cloth().source = MeshFileSource{mesh + ".obj", true};
      grid.cloth().pins = {};
      return grid;
    }();
    const auto scene = buildScene(description, description.settings);
    EXPECT_EQ(scene->cloths.front().uvs.isPattern(), pattern) << name;
    EXPECT_EQ(problemOf(scene->cloths.front().uvs).empty(), std::string(name) != "skater")
        << problemOf(scene->cloths.front().uvs);
  }
}

TEST(GridWarp, isVerticalSinceItsTextureIsThatOfAChecker) {
  const SceneDescription grid = openScene("grid");
  EXPECT_FALSE(buildScene(grid, grid.settings)->cloths.front().uvs.present());
}

}  // namespace
}  // namespace drape::scene
