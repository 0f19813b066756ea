#include "scene/scene.hpp"
#include "sim/error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <fstream>

namespace drape {
namespace {

/// A folder that goes when the test ends.
class Folder {
 public:
  Folder() {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string string() const { return path_.string(); }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

int pinCount(const Scene& scene) {
  return static_cast<int>(std::count(scene.model->pinned.begin(), scene.model->pinned.end(), true));
}

std::string refusal(const std::string& nameOrPath) {
  try {
    static_cast<void>(openScene(nameOrPath));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

constexpr const char* quad = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\n";

TEST(Scenes, areBuiltInWithTitlesAndBuildWithPinsOrBodiesThatHoldTheCloth) {
  const auto scenes = sceneList();
  for (const char* name : {"grid", "flag", "curtain", "skirt"}) {
    EXPECT_TRUE(std::any_of(scenes.begin(), scenes.end(), [&](const SceneInfo& s) { return s.name == name; })) << name;
  }
  for (const SceneInfo& info : scenes) {
    const SceneDescription description = openScene(info.name);
    const auto scene = buildScene(description, description.settings);
    EXPECT_FALSE(info.title.empty());
    EXPECT_FALSE(info.help.empty());
    EXPECT_TRUE(pinCount(*scene) > 0 || !scene->bodies->empty()) << info.name;
    EXPECT_TRUE(isFinite(scene->start)) << info.name;
    EXPECT_EQ(scene->renderMesh.triangles.size(), scene->model->triangles.size()) << info.name;
  }
}

TEST(Scenes, haveThePapersSheetAsGrid) {
  SceneDescription description = openScene("grid");
  description.settings.grid.resolution = 17;
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(scene->model->vertexCount(), 289);
  EXPECT_EQ(scene->model->springs.size(), 800U);
  EXPECT_NEAR(scene->model->totalMass(), 0.1, 1e-14);
  EXPECT_EQ(pinCount(*scene), 2);
  EXPECT_TRUE(scene->model->pinned[0]);
  EXPECT_TRUE(scene->model->pinned[16]);
  for (std::size_t v = 0; v < 289; ++v) {
    EXPECT_EQ(scene->start.positions[v].y(), scene->start.positions[0].y());
    EXPECT_EQ(scene->start.velocities[v], Vec3(Vec3::Zero()));
  }
}

TEST(Scenes, openAMeshFileHangingByItsTop) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", quad));
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(scene->model->vertexCount(), 4);
  EXPECT_EQ(pinCount(*scene), 2);
  EXPECT_LT(scene->groundHeight, 0.0);
  Settings free = description.settings;
  free.mesh.pins = "none";
  EXPECT_EQ(pinCount(*buildScene(description, free)), 0);
}

TEST(Scenes, takeAMeshFilesUnitFromTheSettings) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", quad));
  Settings centimetres = description.settings;
  centimetres.mesh.unit = "cm";
  EXPECT_NEAR(buildScene(description, centimetres)->model->restArea(), 2e-4, 1e-12);
}

TEST(Scenes, turnAMeshUprightWhoseZPointsUp) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 0 2\nf 1 2 3\n"));
  Settings settings = description.settings;
  settings.mesh.up = "z";
  const auto scene = buildScene(description, settings);
  EXPECT_EQ(scene->start.positions[2], Vec3(1.0, 2.0, 0.0));
  EXPECT_EQ(scene->summary.size[1], 2.0);
  EXPECT_TRUE(scene->model->pinned[2]);
}

TEST(Scenes, openAUsersFileWithAMeshBesideIt) {
  const Folder folder;
  folder.write("sheet.obj", quad);
  const auto file = folder.write("mine.toml", "[cloth]\nmesh = \"sheet.obj\"\n[settings]\nstiffness = 42\n");
  const SceneDescription description = openScene(file);
  EXPECT_EQ(description.name, "mine");
  EXPECT_EQ(buildScene(description, description.settings)->settings.step.stiffness, 42.0);
}

TEST(Scenes, sayWhatIsWrongWithAFileThatCannotBeOpened) {
  const Folder folder;
  EXPECT_NE(refusal("no_such_scene").find("built-in scenes are"), std::string::npos);
  EXPECT_NE(refusal(folder.string()).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder.write("picture.png", "x")).find("known endings"), std::string::npos);
  EXPECT_NE(refusal(folder.write("empty.toml", "")).find("[cloth]"), std::string::npos);
}

TEST(Scenes, sayWhichBuiltInMeshesThereAre) {
  const Folder folder;
  const auto file = folder.write("mine.toml", "[cloth]\nmesh = \"builtin:hat.obj\"\n");
  const SceneDescription description = openScene(file);
  EXPECT_THROW(static_cast<void>(buildScene(description, description.settings)), InputError);
}

}  // namespace
}  // namespace drape
