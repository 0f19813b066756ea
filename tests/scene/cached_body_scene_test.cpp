// Bodies of scene files that a vertex cache moves.
#include "io/animation/number_bytes.hpp"
#include "messages/error.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_parts.hpp"
#include "scene/scene_writer.hpp"
#include "sim/contact/bodies/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace drape::scene {
namespace {

namespace fs = std::filesystem;

using io::animation::appendBytes;

/// Two squares with a seam of doubled vertices, after a vertex that no face uses, in centimetres.
constexpr const char* board =
    "v 900 900 900\n"
    "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\n"
    "v 100 100 0\nv 100 0 0\nv 200 0 0\nv 200 100 0\n"
    "f 2 3 4 5\nf 6 7 8 9\n";

/// The vertices of the board, lifted by this [cm].
std::vector<Vec3> lifted(double height) {
  std::vector<Vec3> places{{900, 900, 900}, {0, 0, 0},   {100, 0, 0}, {100, 100, 0}, {0, 100, 0},
                           {100, 100, 0},   {100, 0, 0}, {200, 0, 0}, {200, 100, 0}};
  for (Vec3& place : places) {
    place += Vec3(0.0, 0.0, height);
  }
  return places;
}

/// A PC2 file of these frames.
std::string pc2Of(const std::vector<std::vector<Vec3>>& frames) {
  std::string bytes("POINTCACHE2\0", 12);
  appendBytes(bytes, std::int32_t{1});
  appendBytes(bytes, static_cast<std::int32_t>(frames.front().size()));
  appendBytes(bytes, 0.0F);
  appendBytes(bytes, 1.0F);
  appendBytes(bytes, static_cast<std::int32_t>(frames.size()));
  for (const std::vector<Vec3>& frame : frames) {
    for (const Vec3& place : frame) {
      appendBytes(bytes, place);
    }
  }
  return bytes;
}

class CachedBodies : public ::testing::Test {
 protected:
  CachedBodies() {
    fs::create_directories(folder_);
    write("board.obj", board);
    write("board.pc2", pc2Of({lifted(0.0), lifted(50.0), lifted(20.0)}));
  }
  ~CachedBodies() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  /// A scene with the board and these keys.
  [[nodiscard]] SceneDescription open(const std::string& keys) const {
    return parseScene(
        "[cloth]\ngrid = \"vertical\"\n[[bodies]]\nname = \"board\"\nshape = \"mesh\"\nmesh = \"board.obj\"\n" + keys +
            "\n[settings]\ngrid.resolution = 5\n",
        "boards", "boards.toml", folder_);
  }
  [[nodiscard]] static std::shared_ptr<const Scene> built(const SceneDescription& description) {
    return buildScene(description, description.settings);
  }
  [[nodiscard]] std::string problemOf(const std::string& keys) const {
    try {
      (void)built(open(keys));
    } catch (const messages::InputError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] static const sim::contact::MeshShape& meshOf(const Scene& scene) {
    return *std::get<std::shared_ptr<const sim::contact::MeshShape>>(scene.bodies->at(0).shape);
  }
  /// The height of all vertices of the board [m], which must be the same.
  [[nodiscard]] static double heightAt(const Scene& scene, double time) {
    std::vector<Vec3> positions;
    sim::contact::meshPositionsAt(meshOf(scene), time, positions);
    EXPECT_EQ(positions.size(), 6U) << "the seam is closed, and the unused vertex is left out";
    for (const Vec3& position : positions) {
      EXPECT_NEAR(position.z(), positions.front().z(), 1e-6);
    }
    return positions.front().z();
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / "drape_cached_bodies";
};

TEST_F(CachedBodies, FollowTheCacheInTheOrderOfTheFile) {
  const auto scene = built(open("scale = 0.01\ncache = { file = \"board.pc2\", rate = 10 }"));
  ASSERT_TRUE(meshOf(*scene).deforms());
  std::vector<Vec3> positions;
  sim::contact::meshPositionsAt(meshOf(*scene), 0.1, positions);
  EXPECT_EQ(meshOf(*scene).triangles.size(), 4U);
  double area = 0.0;
  for (const auto& [a, b, c] : meshOf(*scene).triangles) {
    area += 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).z();
  }
  EXPECT_NEAR(area, 2.0, 1e-6) << "each vertex is at its place";
  EXPECT_NEAR(heightAt(*scene, -1.0), 0.0, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 0.05), 0.25, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 0.1), 0.5, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 0.15), 0.35, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 0.2), 0.2, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 5.0), 0.2, 1e-6) << "it rests at the end";
}

TEST_F(CachedBodies, RepeatACacheThatLoops) {
  const auto scene = built(open("scale = 0.01\ncache = { file = \"board.pc2\", rate = 10, loop = true }"));
  EXPECT_NEAR(heightAt(*scene, 0.25), 0.1, 1e-6) << "the first frame follows the last";
  EXPECT_NEAR(heightAt(*scene, 0.3), 0.0, 1e-6);
  EXPECT_NEAR(heightAt(*scene, 3.1), 0.5, 1e-6);
  write("board.pc2", pc2Of({lifted(0.0), lifted(50.0), lifted(0.0)}));
  const auto closed = built(open("scale = 0.01\ncache = { file = \"board.pc2\", rate = 10, loop = true }"));
  EXPECT_NEAR(heightAt(*closed, 0.3), 0.5, 1e-6) << "a last frame like the first one takes no time";
}

TEST_F(CachedBodies, AreNamedWithTheirPlaceInErrors) {
  EXPECT_NE(problemOf("cache = { file = \"none.pc2\" }").find("boards.toml:7: " + (folder_ / "none.pc2").string()),
            std::string::npos)
      << problemOf("cache = { file = \"none.pc2\" }");
  EXPECT_NE(problemOf("cache = { file = \"board.obj\" }").find("a vertex cache is a .pc2 or an .mdd file"),
            std::string::npos);
  EXPECT_NE(problemOf("cache = { file = \"a.mdd\", rate = 30 }").find("leave rate out"), std::string::npos);
  EXPECT_NE(problemOf("cache = { file = \"board.pc2\", rate = 0 }").find("rate"), std::string::npos);
  EXPECT_NE(problemOf("cache = { file = \"board.pc2\" }\nframes = { last = 3 }").find("either frames or"),
            std::string::npos);
  EXPECT_NE(problemOf("cache = { path = \"board.pc2\" }").find("path"), std::string::npos);
  write("board.pc2", pc2Of({std::vector<Vec3>(7, Vec3::Zero())}));
  EXPECT_NE(problemOf("cache = { file = \"board.pc2\" }").find("it moves 7 vertices, but the file of the mesh has 9"),
            std::string::npos);
}

TEST_F(CachedBodies, WarnOfVerticesThatLeaveTheirPlace) {
  std::vector<Vec3> open = lifted(0.0);
  open[5].z() += 30.0;
  write("board.pc2", pc2Of({lifted(0.0), open}));
  const auto scene = built(this->open("cache = { file = \"board.pc2\" }"));
  const auto isThatWarning = [](const std::string& warning) {
    return warning.find("vertices at the place of another one in the mesh move away from it (1 of them)") !=
           std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(scene->summary.warnings, isThatWarning), 1);
  write("board.pc2", pc2Of({lifted(0.0), lifted(30.0)}));
  const auto closed = built(this->open("cache = { file = \"board.pc2\" }"));
  EXPECT_EQ(std::ranges::count_if(closed->summary.warnings, isThatWarning), 0);
}

TEST_F(CachedBodies, AreRefusedWithTooManyTriangles) {
  std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int face = 0; face < 300'001; ++face) {
    faces += "f 1 2 3\n";
  }
  write("board.obj", faces);
  const std::string problem = problemOf("cache = { file = \"board.pc2\" }");
  EXPECT_NE(problem.find("it has 300001 triangles, and the limit for this body is 300000"), std::string::npos)
      << problem;
  for (int face = 0; face < 700'000; ++face) {
    faces += "f 1 2 3\n";
  }
  write("board.obj", faces);
  EXPECT_NE(problemOf("scale = 0.01").find("it has 1000001 triangles, and the limit for this body is 1000000"),
            std::string::npos);
}

TEST_F(CachedBodies, AreSavedWithTheScene) {
  const SceneDescription description =
      open("scale = 0.01\ncache = { file = \"board.pc2\", rate = 12.5, loop = true }\nposition = [0, 1, 0]");
  const auto scene = built(description);
  const WrittenScene written = writeScene(*scene, unchanged(*scene), folder_);
  EXPECT_NE(written.text.find("cache = { file = 'board.pc2', rate = 12.5, loop = true }"), std::string::npos)
      << written.text;
  const SceneDescription again = parseScene(written.text, "again", "again.toml", folder_);
  EXPECT_NEAR(heightAt(*built(again), 0.04), 0.25, 1e-6);
}

TEST_F(CachedBodies, AreOpenedWithTheFilesOfAGarmentAndABody) {
  write("sheet.obj", "v 0 300 0\nv 100 300 0\nv 0 400 0\nf 1 2 3\n");
  SceneParts parts{.cloth = (folder_ / "sheet.obj").string(), .bodies = {(folder_ / "board.obj").string()}};
  parts.caches = {(folder_ / "board.pc2").string()};
  SceneDescription description = openParts(parts);
  description.settings.mesh.unit = "cm";
  description.settings.mesh.up = "y";
  EXPECT_NEAR(heightAt(*built(description), 1.0 / 30.0), 0.5, 1e-6) << "in the unit of the garment";
  EXPECT_EQ(description.parts.caches, parts.caches);
  parts.bodies.push_back((folder_ / "sheet.obj").string());
  parts.caches = {(folder_ / "other.pc2").string()};
  try {
    (void)openParts(parts);
    ADD_FAILURE() << "no InputError";
  } catch (const messages::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no mesh of a body has this name"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace drape::scene
