#include "messages/error.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <string>

namespace drape::scene {
namespace {

/// A folder with the mesh of a square, in centimetres with z up, and a start in which one corner is lifted.
class ClothStart : public ::testing::Test {
 protected:
  ClothStart() {
    std::string pattern = (std::filesystem::temp_directory_path() / "drape-start-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write("square.obj", "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nf 1 2 3\nf 1 3 4\n");
    write("lifted.obj", "v 0 0 0\nv 100 0 0\nv 100 90 40\nv 0 100 0\n" + std::string("f 1 2 3 4\n"));
  }
  ~ClothStart() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  [[nodiscard]] SceneDescription described(const std::string& cloth, const std::string& settings = "") const {
    const std::string text = "[cloth]\nmesh = \"square.obj\"\n" + cloth + "\n[settings]\nunit = \"cm\"\nup = \"z\"\n" +
                             "material.model = \"springs\"\n" + settings;
    return parseScene(text, "start", "start.toml", folder_);
  }

  [[nodiscard]] std::shared_ptr<const Scene> built(const std::string& cloth, const std::string& settings = "") const {
    const SceneDescription description = described(cloth, settings);
    return buildScene(description, description.settings);
  }

  [[nodiscard]] std::string problemOf(const std::string& cloth) const {
    try {
      (void)built(cloth);
    } catch (const messages::InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "no InputError";
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(ClothStart, PutsTheVerticesWhereTheSecondFileHasThem) {
  const auto scene = built("start = \"lifted.obj\"");
  EXPECT_TRUE(scene->start.positions[2].isApprox(Vec3(1.0, 0.4, -0.9), 1e-6)) << scene->start.positions[2].transpose();
  EXPECT_TRUE(scene->start.positions[3].isApprox(Vec3(0.0, 0.0, -1.0), 1e-6));
  EXPECT_TRUE(scene->start.velocities[2].isZero(0.0));
}

TEST_F(ClothStart, LeavesTheRestShapeAlone) {
  const auto without = built("");
  const auto with = built("start = \"lifted.obj\"");
  ASSERT_EQ(with->model->springs.size(), without->model->springs.size());
  for (std::size_t s = 0; s < with->model->springs.size(); ++s) {
    EXPECT_EQ(with->model->springs[s].restLength, without->model->springs[s].restLength);
  }
  EXPECT_EQ(with->model->vertexMass, without->model->vertexMass);
  EXPECT_EQ(with->restPositions, without->restPositions);
}

TEST_F(ClothStart, MovesWithPositionRotationAndPlacementButKeepsItsSize) {
  const auto scene = built(
      "start = \"lifted.obj\"\nposition = [0, 1, 0]\n"
      "placement = { position = [0.5, 0, 0], rotation = [0, 90, 0], scale = 2 }");
  // Up by 1 m, then about y: (x, y, z) becomes (z, y, -x).
  EXPECT_TRUE(scene->start.positions[2].isApprox(Vec3(-0.9 + 0.5, 1.4, -1.0), 1e-6))
      << scene->start.positions[2].transpose();
  EXPECT_NEAR(scene->model->springs[0].restLength, 2.0, 1e-9);
}

TEST_F(ClothStart, HoldsPinsWhereTheyStart) {
  const auto scene = built("start = \"lifted.obj\"\n[pins]\nvertices = [2]");
  EXPECT_TRUE(scene->model->pinned[2]);
  EXPECT_NEAR(scene->start.positions[2].y(), 0.4, 1e-6);
}

TEST_F(ClothStart, IsDividedWithItsMesh) {
  const auto scene = built("start = \"lifted.obj\"", "subdivide = 1\n");
  ASSERT_EQ(scene->start.positions.size(), 9U);
  double highest = 0.0;
  for (std::size_t v = 4; v < 9; ++v) {
    highest = std::max(highest, scene->start.positions[v].y());
  }
  EXPECT_NEAR(highest, 0.2, 1e-6);
}

TEST_F(ClothStart, SurvivesSavingAndReading) {
  const auto scene = built("start = \"lifted.obj\"\nposition = [0, 1, 0]");
  const WrittenScene written = writeScene(*scene, unchanged(*scene), folder_);
  EXPECT_NE(written.text.find("start = 'lifted.obj'"), std::string::npos) << written.text;
  const SceneDescription again = parseScene(written.text, "again", "again.toml", folder_);
  EXPECT_EQ(buildScene(again, again.settings)->start.positions, scene->start.positions);
}

TEST_F(ClothStart, NamesFilesThatDoNotFit) {
  write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string problem = problemOf("start = \"triangle.obj\"");
  EXPECT_NE(problem.find("start.toml:3"), std::string::npos) << problem;
  EXPECT_NE(problem.find("triangle.obj has 3 vertices, and the mesh of the cloth 4"), std::string::npos) << problem;
  EXPECT_NE(problemOf("start = \"nowhere.obj\"").find("nowhere.obj: no such file"), std::string::npos);
  EXPECT_NE(problemOf("start = \"cloth.pc2\"").find("start must name a mesh file"), std::string::npos);
  EXPECT_NE(problemOf("start = \"lifted.obj\"\npleats = { count = 3 }").find("either pleats or a start"),
            std::string::npos);
}

}  // namespace
}  // namespace drape::scene
