#include "io/mesh_import.hpp"
#include "program.hpp"
#include "scene/scene.hpp"
#include "scene/scene_file.hpp"
#include "sim/contact/bodies/world.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace drape::app::testing {
namespace {

/// A sheet in centimetres, z up, with quads, a seam of doubled vertices, and a vertex that no face uses.
std::filesystem::path makeSheet(const std::filesystem::path& folder) {
  const auto file = folder / "sheet.obj";
  std::ofstream obj(file);
  obj << "v 1000 0 0\n";  // unused
  constexpr int columns = 9;
  for (const int half : {1, 0}) {
    for (int row = 0; row < columns; ++row) {
      for (int column = 0; column < 5; ++column) {
        obj << "v " << 10 * (4 * half + column) << " 0 " << 100 - 10 * row << "\n";
      }
    }
  }
  for (int half = 0; half < 2; ++half) {
    for (int row = 0; row + 1 < columns; ++row) {
      for (int column = 0; column + 1 < 5; ++column) {
        const int first = 2 + 45 * half + 5 * row + column;
        obj << "f " << first << ' ' << first + 5 << ' ' << first + 6 << ' ' << first + 1 << "\n";
      }
    }
  }
  return file;
}

constexpr const char* sheetSettings = " --set unit=cm --set up=z --set pins=top ";

std::vector<Vec3> verticesOf(const std::filesystem::path& obj) {
  std::vector<Vec3> vertices;
  std::ifstream stream(obj);
  std::string keyword;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    Vec3 at;
    if (words >> keyword && keyword == "v" && words >> at[0] >> at[1] >> at[2]) {
      vertices.push_back(at);
    }
  }
  return vertices;
}

TEST(Export, fitsTheOpenedFileVertexByVertex) {
  const auto folder = testFolder();
  const auto sheet = makeSheet(folder);
  const Outcome outcome =
      headless("run " + sheet.string() + sheetSettings + "--seconds 0.2 --export " +
               (folder / "f_{frame:3}.obj").string() + " --export " + (folder / "end.obj").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::vector<Vec3> wanted = verticesOf(sheet);
  const std::vector<Vec3> start = verticesOf(folder / "f_000.obj");
  ASSERT_EQ(start.size(), wanted.size());
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    EXPECT_LT((start[v] - wanted[v]).norm(), 1e-4) << "vertex " << v;  // [cm]
  }
  // The seam stays together, the cloth falls, and the vertex without a face stays.
  const std::vector<Vec3> end = verticesOf(folder / "end.obj");
  ASSERT_EQ(end.size(), wanted.size());
  EXPECT_EQ(end, verticesOf(folder / "f_006.obj"));
  EXPECT_EQ(end[0], Vec3(1000, 0, 0));
  for (std::size_t row = 0; row < 9; ++row) {
    EXPECT_EQ(end[1 + 5 * row], end[1 + 45 + 5 * row + 4]);
  }
  EXPECT_LT(end[45].z(), wanted[45].z() - 0.001);
  const std::string text = readFile(folder / "end.obj");
  EXPECT_NE(text.find("\nf 2//2 7//7 8//8 3//3\n"), std::string::npos) << "the quads of the file";
}

TEST(Export, canBeInTheCoordinatesOfTheScene) {
  const auto folder = testFolder();
  const auto sheet = makeSheet(folder);
  ASSERT_EQ(headless("run " + sheet.string() + sheetSettings + "--seconds 0 --coordinates scene --export " +
                     (folder / "end.obj").string())
                .status,
            0);
  const std::vector<Vec3> end = verticesOf(folder / "end.obj");
  EXPECT_NEAR(end[1].y(), end[45].y() + 0.8, 1e-6);  // 80 cm above, along y
}

TEST(Export, writesAFileForEachClothWhereAFormatHoldsOne) {
  const auto folder = testFolder();
  const Outcome refused = headless("run table_runner --seconds 0 --export " + (folder / "a.pc2").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("{cloth}"), std::string::npos) << refused.errors;
  const Outcome outcome =
      headless("run table_runner --seconds 0.1 --export " + (folder / "{cloth}.pc2").string() + " --export " +
               (folder / "all.usda").string() + " --export " + (folder / "all.glb").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  int caches = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    caches += entry.path().extension() == ".pc2" ? 1 : 0;
  }
  EXPECT_EQ(caches, 2);
  const std::string usda = readFile(folder / "all.usda");
  EXPECT_NE(usda.find("def Mesh", usda.find("def Mesh") + 1), std::string::npos);
  EXPECT_NE(usda.find("Made with Drape from table_runner\""), std::string::npos) << "not from one of its cloths";
}

TEST(Export, hasExactFrameTimes) {
  const auto folder = testFolder();
  const Outcome outcome = headless("run grid --seconds 0.5 --rate 24 --export " + (folder / "a.csv").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.errors.find("time step is 1/168 s"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.output.find("13 frames"), std::string::npos) << outcome.output;
  const Outcome refused =
      headless("run grid --seconds 0.5 --rate 24 --set time_step=0.01 --export " + (folder / "a.csv").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("--set time_step=1/120"), std::string::npos) << refused.errors;
  EXPECT_EQ(refused.errors.find("note: the time step"), std::string::npos) << "--set wins: " << refused.errors;
}

TEST(Export, putsSettingsIntoNames) {
  const auto folder = testFolder();
  ASSERT_EQ(
      headless("run grid --seconds 0 --set stiffness=50 --export " + (folder / "k{stiffness}.obj").string()).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "k50.obj"));
}

TEST(Export, refusesUnknownFormatsAndFoldersThatCannotBe) {
  const auto folder = testFolder();
  const Outcome unknown = headless("run grid --seconds 0 --export " + (folder / "a.abc").string());
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find(".usda"), std::string::npos) << unknown.errors;
  std::ofstream(folder / "file") << "x";
  const Outcome blocked = headless("run grid --seconds 0 --export " + (folder / "file" / "a.obj").string());
  EXPECT_EQ(blocked.status, 1);
  EXPECT_NE(blocked.errors.find("cannot create the folder"), std::string::npos) << blocked.errors;
}

TEST(Export, canMoveABodyAsAVertexCache) {
  const auto folder = testFolder();
  const auto sheet = makeSheet(folder);
  const Outcome outcome = headless("run " + sheet.string() + sheetSettings + "--seconds 0.2 --rate 50 --export " +
                                   (folder / "sheet.pc2").string() + " --export " + (folder / "sheet.mdd").string() +
                                   " --export " + (folder / "f_{frame:3}.obj").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* cache : {"file = \"sheet.pc2\", rate = 50", "file = \"sheet.mdd\""}) {
    const scene::SceneDescription description = scene::parseScene(
        "[cloth]\ngrid = \"vertical\"\n[[bodies]]\nshape = \"mesh\"\nmesh = \"sheet.obj\"\nscale = "
        "0.01\nrotation = [-90, 0, 0]\ncache = { " +
            std::string(cache) + " }\n",
        "cached", "cached.toml", folder);
    const auto scene = scene::buildScene(description, description.settings);
    const sim::contact::Body& body = scene->bodies->front();
    const auto& mesh = *std::get<std::shared_ptr<const sim::contact::MeshShape>>(body.shape);
    const sim::contact::Pose pose = sim::contact::poseAt(body.motion, 0.0);
    for (int frame = 0; frame <= 10; ++frame) {
      std::vector<Vec3> positions;
      sim::contact::meshPositionsAt(mesh, frame / 50.0, positions);
      ASSERT_EQ(positions.size(), 81U) << "without the seam and the unused vertex";
      // Each vertex of the cloth is a vertex of the body.
      for (const Vec3& inFile : verticesOf(folder / fmt::format("f_{:03}.obj", frame))) {
        const Vec3 place = 0.01 * Vec3(inFile.x(), inFile.z(), -inFile.y());
        const auto isThere = [&](const Vec3& position) { return (pose.toWorld(position) - place).norm() < 1e-6; };
        EXPECT_TRUE(inFile.x() == 1000.0 || std::ranges::any_of(positions, isThere)) << cache << ", frame " << frame;
      }
    }
  }
}

}  // namespace
}  // namespace drape::app::testing
