#include "scene/rest_pattern.hpp"

#include "mesh_text_test.hpp"
#include "messages/error.hpp"
#include "scene/cloth_material.hpp"
#include "scene/scene.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drape::scene {
namespace {

/// A vertical square of 1 m x 1 m in two triangles, with one texture coordinate for each corner.
std::string squareWith(const char* uvs) {
  return std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n") + uvs + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
}

constexpr const char* halfSize = "vt 0 0\nvt 0.5 0\nvt 0.5 0.5\nvt 0 0.5\n";

class RestPattern : public MeshTextTest {
 protected:
  RestPattern() : MeshTextTest({"material.model=fabric", "fabric.rest_shape=uv"}) {}
};

Vec2 sideOf(const Scene& scene, std::size_t triangle, std::size_t side) {
  return scene.model->fabric->shape.triangles[triangle].sides[side];
}

TEST_F(RestPattern, HasTheAreaOfTheMeshUnlessAScaleIsGiven) {
  const auto even = build(squareWith(halfSize));
  EXPECT_NEAR(patternScale(even->cloths.front().uvs, even->settings), 2.0, 1e-12);
  EXPECT_NEAR(even->model->restArea(), 1.0, 1e-12);
  EXPECT_NEAR(even->model->fabric->meshStrain->high, 0.0, 1e-12);
  const auto smaller = build(squareWith(halfSize), {"fabric.uv_scale=1.6"});
  EXPECT_NEAR(smaller->model->restArea(), 0.64, 1e-12);
  EXPECT_NEAR(smaller->model->fabric->meshStrain->median, 0.25, 1e-12);
  EXPECT_EQ(restShapeNote(*smaller->model, smaller->cloths.front().uvs, smaller->settings), "");
  EXPECT_EQ(restShapeInWords(*smaller->model, smaller->cloths.front().uvs, smaller->settings),
            "the pattern in the UVs, 1.6 m a unit; the mesh is strained against it by 25.0 % (median), 25.0 % (99th "
            "percentile)");
}

TEST_F(RestPattern, WeighsWhatItsOwnAreaWeighs) {
  const std::vector<std::string> small{"fabric.uv_scale=1.6", "density=0.5"};
  EXPECT_NEAR(build(squareWith(halfSize), small)->model->totalMass(), 0.5 * 0.64, 1e-12);
  EXPECT_NEAR(build(squareWith(halfSize), {"fabric.uv_scale=1.6", "mass=0.3"})->model->totalMass(), 0.3, 1e-12);
}

TEST_F(RestPattern, HasWarpAlongVOnEitherSideAndTurnsItByTheAngle) {
  const char* mirrored = "vt 0.5 0\nvt 0 0\nvt 0 0.5\nvt 0.5 0.5\n";
  for (const char* const uvs : {halfSize, mirrored}) {
    // The first side runs along x, the second along V; weft is normal x warp, which points along -x.
    const auto scene = build(squareWith(uvs));
    EXPECT_LT((sideOf(*scene, 0, 0) - Vec2(0.0, -1.0)).norm(), 1e-12);
    EXPECT_LT((sideOf(*scene, 0, 1) - Vec2(1.0, 0.0)).norm(), 1e-12);
    EXPECT_EQ(warpInWords(scene->cloths.front().uvs, scene->settings), "along V of the UVs");
    // The same as the mesh with its warp turned as far.
    const auto turned = build(squareWith(uvs), {"fabric.warp_angle=30"});
    const auto mesh = build(squareWith(uvs), {"fabric.warp_angle=30", "fabric.rest_shape=mesh", "fabric.warp_from=uv"});
    for (const std::size_t side : {0U, 1U, 2U}) {
      EXPECT_LT((sideOf(*turned, 0, side) - sideOf(*mesh, 0, side)).norm(), 1e-12);
    }
  }
}

TEST_F(RestPattern, DoesNotCountForSpringsAndIsNoticedByTheModelThatReturnsToTheMesh) {
  EXPECT_FALSE(build(squareWith(halfSize), {"material.model=springs"})->model->hasPattern);
  const auto scene = build(squareWith(halfSize), {"fabric.uv_scale=1.6", "density=0.5"});
  settings::Settings changed = scene->settings;
  settings::assignSettingExpression(changed, "fabric.rest_shape=mesh");
  const auto mesh = withMaterial(*scene->model, scene->cloths, changed);
  EXPECT_FALSE(mesh->fabric->meshStrain);
  EXPECT_NEAR(mesh->totalMass(), 0.5, 1e-12);
  settings::assignSettingExpression(changed, "material.model=springs");
  const auto springs = withMaterial(*scene->model, scene->cloths, changed);
  EXPECT_NEAR(springs->totalMass(), 0.5, 1e-12);
  EXPECT_EQ(springs->springs[0].restLength, 1.0);
}

TEST_F(RestPattern, IsRefusedWithoutSoundTextureCoordinates) {
  const std::string bare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
  EXPECT_NE(refusal(bare).find("fabric.rest_shape = uv cannot be used: the mesh has no texture coordinates (UVs)"),
            std::string::npos)
      << refusal(bare);
  const std::string flat = refusal(squareWith("vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n"));
  EXPECT_NE(flat.find("give no area to 1 triangle (number 1)"), std::string::npos) << flat;
  EXPECT_NE(flat.find("use fabric.rest_shape = mesh"), std::string::npos) << flat;
  const std::string folded = refusal(squareWith("vt 0 0\nvt 1 0\nvt 1 1\nvt 0.9 0.1\n"));
  EXPECT_NE(folded.find("mirror 1 triangle (number 1) against"), std::string::npos) << folded;
  SceneDescription grid = openScene("grid");
  settings::assignSettingExpression(grid.settings, "material.model=fabric");
  for (const auto& [setting, remedy] :
       {std::pair("fabric.rest_shape=uv", "Use fabric.rest_shape = mesh, or open a"),
        std::pair("fabric.warp_from=uv", "Use fabric.warp_from = vertical, or open a")}) {
    settings::Settings settings = grid.settings;
    settings::assignSettingExpression(settings, setting);
    try {
      static_cast<void>(buildScene(grid, settings));
      ADD_FAILURE() << setting;
    } catch (const messages::InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("a grid has no texture coordinates"), std::string::npos) << message;
      EXPECT_NE(message.find(remedy), std::string::npos) << message;
      EXPECT_EQ(message.find("in the file"), std::string::npos) << message;
    }
  }
}

TEST_F(RestPattern, IsRefusedWithAVerticalWarpOrASenselessScale) {
  const std::string vertical = refusal(squareWith(halfSize), {"fabric.warp_from=vertical"});
  EXPECT_NE(vertical.find("fabric.warp_from = vertical is not possible"), std::string::npos) << vertical;
  const std::string tiny = refusal(squareWith(halfSize), {"fabric.uv_scale=0.001"});
  EXPECT_NE(tiny.find("fabric.uv_scale = 0.001 gives the pattern 1/4e+06 of the area of the mesh. Use 2, or 0"),
            std::string::npos)
      << tiny;
  for (const char* const text :
       {"fabric.uv_scale=-1", "fabric.uv_scale=nan", "fabric.uv_scale=101", "fabric.rest_shape=pattern"}) {
    settings::Settings settings;
    EXPECT_THROW(settings::assignSettingExpression(settings, text), messages::UsageError) << text;
  }
}

TEST_F(RestPattern, IsDoubtedWhereItHardlyFitsTheMesh) {
  const auto large = build(squareWith(halfSize), {"fabric.uv_scale=5"});
  EXPECT_EQ(restShapeNote(*large->model, large->cloths.front().uvs, large->settings),
            "fabric.uv_scale gives the pattern 6.25 times the area of the mesh; with 2 they are equal");
  const auto wide = build(squareWith("vt 0 0\nvt 4 0\nvt 4 1\nvt 0 1\n"));
  EXPECT_EQ(restShapeNote(*wide->model, wide->cloths.front().uvs, wide->settings),
            "the UVs are unlikely to be the pattern of this mesh: it is strained against them by 100 % (median), 100 % "
            "(99th percentile), and more in one direction than in the other");
}

TEST(BuiltInPatterns, fitTheirMeshesExceptThatOfTheCape) {
  for (const auto& [name, fits] : {std::pair("tshirt", true), {"skirt", true}, {"poncho", true}, {"cape", false}}) {
    SceneDescription description = openScene("grid");
    description.cloth().source = MeshFileSource{std::string(name) + ".obj", true};
    description.cloth().pins.clear();
    for (const char* const expression : {"material.model=fabric", "fabric.rest_shape=uv"}) {
      settings::assignSettingExpression(description.settings, expression);
    }
    const auto scene = buildScene(description, description.settings);
    EXPECT_EQ(restShapeNote(*scene->model, scene->cloths.front().uvs, scene->settings).empty(), fits)
        << name << ": " << restShapeInWords(*scene->model, scene->cloths.front().uvs, scene->settings);
  }
}

}  // namespace
}  // namespace drape::scene
