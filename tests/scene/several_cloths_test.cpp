#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "scene/cloth_material.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>
#include <string>

namespace drape::scene {
namespace {

/// A sheet of 5 x 5 vertices over one of 4 x 4, which is pinned at a corner.
constexpr const char* twoSheets = R"(
[[cloths]]
name = "upper"
grid = "horizontal"
position = [0, 1, 0]

[[cloths]]
name = "lower"
grid = "horizontal"
rotation = [0, 90, 0]
pins = { corners = ["top_left"] }
settings = { "grid.resolution" = 4, density = 0.6 }

[settings]
grid.resolution = 5
density = 0.2
)";

SceneDescription sceneOf(const std::string& text) {
  return parseScene(text, "test", "test.toml", {});
}

std::shared_ptr<const Scene> builtFrom(const std::string& text) {
  const SceneDescription description = sceneOf(text);
  return buildScene(description, description.settings);
}

std::string refusalOf(const std::string& text) {
  try {
    static_cast<void>(builtFrom(text));
  } catch (const messages::InputError& error) {
    return error.what();
  }
  return "accepted";
}

double massOf(const Scene& scene, const ClothPart& cloth) {
  const auto first = scene.model->vertexMass.begin() + cloth.firstVertex;
  return std::accumulate(first, first + cloth.vertexCount, 0.0);
}

TEST(SeveralCloths, areOneModelWithoutASpringBetweenThem) {
  const auto scene = builtFrom(twoSheets);
  ASSERT_EQ(scene->cloths.size(), 2U);
  EXPECT_EQ(scene->cloths[0].vertexCount, 25);
  EXPECT_EQ(scene->cloths[1].vertexCount, 16);
  EXPECT_EQ(scene->cloths[1].firstVertex, 25);
  EXPECT_EQ(scene->cloths[1].firstTriangle, 32);
  EXPECT_EQ(scene->model->vertexCount(), 41);
  EXPECT_EQ(scene->model->triangles.size(), 50U);
  for (const sim::Spring& spring : scene->model->springs) {
    EXPECT_TRUE(scene->model->areInOneCloth(spring.a, spring.b));
  }
  EXPECT_FALSE(scene->model->areInOneCloth(0, 25));
}

TEST(SeveralCloths, haveTheirOwnPositionsPinsMassesAndGrids) {
  const auto scene = builtFrom(twoSheets);
  EXPECT_EQ(scene->start.positions[0].y(), 1.0);
  EXPECT_NEAR(scene->start.positions[25].y(), 0.0, 1e-12);
  EXPECT_NEAR(scene->start.positions[25].z(), 0.5, 1e-12) << "turned by 90 degrees about y";
  EXPECT_EQ(std::count(scene->model->pinned.begin(), scene->model->pinned.end(), true), 1);
  EXPECT_TRUE(scene->model->pinned[25]) << "corners are those of the cloth's own grid";
  EXPECT_NEAR(massOf(*scene, scene->cloths[0]), 0.2, 1e-12);
  EXPECT_NEAR(massOf(*scene, scene->cloths[1]), 0.6, 1e-12);
}

TEST(SeveralCloths, canBeFrozenWithAllTheirVertices) {
  std::string text = twoSheets;
  text.insert(text.find("position"), "frozen = true\n");
  const auto scene = builtFrom(text);
  for (int v = 0; v < scene->model->vertexCount(); ++v) {
    EXPECT_EQ(scene->model->pinned[v], v <= 25) << v << ": all of the upper sheet, a corner of the lower one";
  }
  const auto fine = builtFrom(text + "subdivide = 1\n");
  const ClothPart& upper = fine->cloths[0];
  EXPECT_EQ(std::count(fine->model->pinned.begin(), fine->model->pinned.begin() + upper.vertexCount, true),
            upper.vertexCount);
  EXPECT_NE(refusalOf("[cloth]\ngrid = \"vertical\"\nfrozen = 3\n").find("frozen"), std::string::npos);
}

TEST(SeveralCloths, haveTheirOwnFabrics) {
  const std::string upper = "[[cloths]]\nname = \"upper\"\ngrid = \"horizontal\"\n";
  const std::string lower = "[[cloths]]\nname = \"lower\"\ngrid = \"horizontal\"\nposition = [0, -1, 0]\n";
  const std::string denim = "settings = { \"material.preset\" = \"denim\" }\n";
  const std::string settings =
      "[settings]\nmaterial.model = \"fabric\"\nmaterial.preset = \"silk\"\ngrid.resolution = 5\n";
  const auto scene = builtFrom(upper + lower + denim + settings);
  ASSERT_NE(scene->model->fabric, nullptr);
  EXPECT_EQ(scene->model->fabric->materials[0], fabrics::findPreset("silk")->material);
  EXPECT_EQ(scene->model->fabric->materials[32], fabrics::findPreset("denim")->material);
  EXPECT_NEAR(massOf(*scene, scene->cloths[0]), fabrics::findPreset("silk")->density, 1e-12);
  EXPECT_NEAR(massOf(*scene, scene->cloths[1]), fabrics::findPreset("denim")->density, 1e-12);
  EXPECT_EQ(materialInWords(scene->cloths, scene->settings, 0), "Silk");
  EXPECT_EQ(materialInWords(scene->cloths, scene->settings, 1), "Denim");
  const auto equal = builtFrom(upper + lower + settings);
  EXPECT_EQ(equal->model->fabric->materials.list().size(), 1U) << "equal fabrics are one material";
  EXPECT_EQ(materialInWords(equal->cloths, equal->settings, 0), "Silk");
}

TEST(SeveralCloths, haveTheirOwnStiffnessOfSprings) {
  std::string text = twoSheets;
  text.replace(text.find("density = 0.6"), 13, "stiffness = 900");
  text += "stiffness = 300\n";
  const auto scene = builtFrom(text);
  for (const sim::Spring& spring : scene->model->springs) {
    EXPECT_EQ(spring.relativeStiffness, spring.a < 25 ? 1.0 : 3.0);
  }
}

TEST(SeveralCloths, haveOneRenderMeshWithTheirTrianglesInOrder) {
  const auto scene = builtFrom(twoSheets);
  ASSERT_EQ(scene->renderMesh.triangles.size(), scene->model->triangles.size());
  for (std::size_t t = 0; t < scene->model->triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(scene->renderMesh.particle[scene->renderMesh.triangles[t][corner]], scene->model->triangles[t][corner]);
    }
  }
}

TEST(SeveralCloths, areTheSameAsOneClothIfThereIsOne) {
  const char* sheet = "grid = \"vertical\"\npins = { edges = [\"top\"] }\n[settings]\ngrid.resolution = 6\n";
  const auto listed = builtFrom("[[cloths]]\nname = \"sheet\"\n" + std::string(sheet));
  const auto alone =
      builtFrom("[cloth]\ngrid = \"vertical\"\n[pins]\nedges = [\"top\"]\n[settings]\ngrid.resolution = 6\n");
  EXPECT_EQ(listed->model->restPositions, alone->model->restPositions);
  EXPECT_EQ(listed->model->vertexMass, alone->model->vertexMass);
  EXPECT_EQ(listed->model->pinned, alone->model->pinned);
}

TEST(SeveralCloths, refusesWhatDoesNotFitTogether) {
  const std::string sheet = "[[cloths]]\nname = \"a\"\ngrid = \"vertical\"\n";
  EXPECT_NE(refusalOf("[cloth]\ngrid = \"vertical\"\n" + sheet).find("either a table [cloth] or tables [[cloths]]"),
            std::string::npos);
  EXPECT_NE(refusalOf("title = \"empty\"\n").find("either a table [cloth] or tables [[cloths]]"), std::string::npos);
  EXPECT_NE(refusalOf(sheet + sheet).find("test.toml:4: there are two cloths with the name \"a\""), std::string::npos);
  EXPECT_NE(refusalOf("[[cloths]]\ngrid = \"vertical\"\n").find("test.toml:1: every table of [[cloths]] needs a name"),
            std::string::npos);
  EXPECT_NE(refusalOf(sheet + "[pins]\ntop = 0.1\n").find("each cloth has its own pins"), std::string::npos);
  const std::string shared = refusalOf(sheet + "settings = { time_step = 0.01 }\n");
  EXPECT_NE(shared.find("test.toml:4: time_step is the same for all cloths"), std::string::npos) << shared;
  const std::string model = refusalOf(sheet + "settings = { \"material.model\" = \"fabric\" }\n");
  EXPECT_NE(model.find("material.model is the same for all cloths"), std::string::npos) << model;
  const std::string range = refusalOf(sheet + "settings = { density = -1 }\n");
  EXPECT_NE(range.find("test.toml:4: density"), std::string::npos) << range;
}

}  // namespace
}  // namespace drape::scene
