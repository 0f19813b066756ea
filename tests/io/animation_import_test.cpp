#include "io/animation_import.hpp"

#include "animation_files.hpp"
#include "glb_file.hpp"
#include "input_error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace drape::io {
namespace {

/// A folder for one test.
class Files {
 public:
  Files() {
    std::string pattern = (std::filesystem::temp_directory_path() / "drape-animation-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Files() { std::filesystem::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  Files(Files&&) = delete;
  Files& operator=(Files&&) = delete;

  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

AnimatedMesh readBar(const BarFile& bar, const AnimationOptions& options) {
  const Files files;
  return importAnimation(files.write("bar.gltf", bar.text()), options);
}

std::string problemOf(const BarFile& bar, const AnimationOptions& options) {
  return inputErrorOf([&] { (void)readBar(bar, options); });
}

AnimationOptions clipAt(const std::string& clip, double rate) {
  AnimationOptions options;
  options.clip = clip;
  options.rate = rate;
  return options;
}

/// The vertex of the first frame at this place.
std::size_t vertexAt(const AnimatedMesh& mesh, const Vec3& place) {
  for (std::size_t v = 0; v < mesh.frames.front().size(); ++v) {
    if ((mesh.frames.front()[v] - place).norm() < 1e-6) {
      return v;
    }
  }
  ADD_FAILURE() << "no vertex at " << place.transpose();
  return 0;
}

TEST(AnimationImport, movesEachVertexWithTheWeightsOfItsBones) {
  const AnimatedMesh mesh = readBar({}, clipAt("bend", 2.0));
  EXPECT_EQ(mesh.triangles.size(), 4U);
  ASSERT_EQ(mesh.frames.size(), 5U);
  EXPECT_DOUBLE_EQ(mesh.frameTime, 0.5);
  const std::size_t tip = vertexAt(mesh, {0.0, 2.0, 0.0});
  const std::size_t middle = vertexAt(mesh, {1.0, 1.0, 0.0});
  const std::size_t foot = vertexAt(mesh, {1.0, 0.0, 0.0});
  for (std::size_t k = 0; k < 5; ++k) {
    // The keys at 0, 1 and 2 s turn the upper bone by 45 degrees each about (0, 1, 0).
    const double angle = std::numbers::pi / 8.0 * static_cast<double>(k);
    const Vec3 turned(-std::sin(angle), 1.0 + std::cos(angle), 0.0);
    EXPECT_LT((mesh.frames[k][tip] - turned).norm(), 1e-5) << k;
    const Vec3 half = 0.5 * Vec3(1.0, 1.0, 0.0) + 0.5 * Vec3(std::cos(angle), 1.0 + std::sin(angle), 0.0);
    EXPECT_LT((mesh.frames[k][middle] - half).norm(), 1e-5) << k;
    EXPECT_LT((mesh.frames[k][foot] - Vec3(1.0, 0.0, 0.0)).norm(), 1e-6) << k;
  }
}

/// The tip of the bar where the upper bone is turned by an angle.
Vec3 tipAt(double angle) {
  return {-std::sin(angle), 1.0 + std::cos(angle), 0.0};
}

TEST(AnimationImport, beginsInTheBindPoseAndBlendsIntoTheClip) {
  AnimationOptions options = clipAt("bend", 10.0);
  options.blend = 1.0;
  options.loop = true;
  BarFile bar;
  bar.upperPose = R"(,"rotation":[0,0,0.70710678,0.70710678])";  // it is not modelled like this
  const AnimatedMesh mesh = readBar(bar, options);
  ASSERT_EQ(mesh.leadFrames, 10U);
  ASSERT_EQ(mesh.frames.size(), 31U);
  const std::size_t tip = vertexAt(mesh, {0.0, 2.0, 0.0});
  for (const std::size_t k : {0U, 3U, 5U, 9U}) {
    // The clip runs meanwhile: it is 1 s before its end at first, where its angle is 45 degrees.
    const double x = static_cast<double>(k) / 10.0;
    const double angle = x * x * (3.0 - 2.0 * x) * std::numbers::pi / 4.0 * (1.0 + x);
    EXPECT_LT((mesh.frames[k][tip] - tipAt(angle)).norm(), 1e-5) << k;
  }
  EXPECT_LT((mesh.frames[10][tip] - tipAt(0.0)).norm(), 1e-5);
  EXPECT_LT((mesh.frames[20][tip] - tipAt(std::numbers::pi / 4.0)).norm(), 1e-5);
}

TEST(AnimationImport, waitsForAClipThatDoesNotLoopAtItsStart) {
  AnimationOptions options = clipAt("bend", 10.0);
  options.blend = 0.5;
  const AnimatedMesh mesh = readBar({}, options);
  ASSERT_EQ(mesh.leadFrames, 5U);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_LT((mesh.frames[k][vertexAt(mesh, {0.0, 2.0, 0.0})] - tipAt(0.0)).norm(), 1e-5) << k;
  }
}

TEST(AnimationImport, holdsTheKeysOfStepsUntilTheNextOne) {
  BarFile bar;
  bar.interpolation = "STEP";
  const AnimatedMesh mesh = readBar(bar, clipAt("bend", 4.0));
  ASSERT_EQ(mesh.frames.size(), 9U);
  const std::size_t tip = vertexAt(mesh, {0.0, 2.0, 0.0});
  for (std::size_t k = 0; k < mesh.frames.size(); ++k) {
    const double angle = std::numbers::pi / 4.0 * static_cast<double>(k / 4);
    EXPECT_LT((mesh.frames[k][tip] - tipAt(angle)).norm(), 1e-5) << k;
  }
}

TEST(AnimationImport, followsCubicCurvesBetweenTheKeysInBothFormsOfGltf) {
  BarFile bar;
  bar.interpolation = "CUBICSPLINE";
  const Files files;
  const std::string text = bar.text();
  for (const auto& file : {files.write("bar.gltf", text), files.write("bar.glb", glbFile(text))}) {
    const AnimatedMesh mesh = importAnimation(file, clipAt("bend", 4.0));
    ASSERT_EQ(mesh.frames.size(), 9U);
    const std::size_t tip = vertexAt(mesh, {0.0, 2.0, 0.0});
    for (std::size_t k = 0; k < 4; ++k) {
      // Between 0 and 45 degrees, without tangents, and normalised.
      const double s = static_cast<double>(k) / 4.0;
      const double late = s * s * (3.0 - 2.0 * s);
      const double sine = late * std::sin(std::numbers::pi / 8.0);
      const double cosine = 1.0 - late + late * std::cos(std::numbers::pi / 8.0);
      EXPECT_LT((mesh.frames[k][tip] - tipAt(2.0 * std::atan2(sine, cosine))).norm(), 1e-4) << file << " " << k;
    }
    EXPECT_LT((mesh.frames[8][tip] - tipAt(std::numbers::pi / 2.0)).norm(), 1e-5) << file;
  }
}

TEST(AnimationImport, takesTheBindPoseFromTheBonesWhereTheNodeOfTheMeshIsElsewhere) {
  AnimationOptions options = clipAt("still", 10.0);
  options.blend = 0.5;
  BarFile bar;
  bar.meshPose = R"(,"scale":[100,100,100])";
  const AnimatedMesh mesh = readBar(bar, options);
  EXPECT_LT(vertexAt(mesh, {0.0, 2.0, 0.0}), 6U);
}

TEST(AnimationImport, movesTheBoneOfTwoNodesWithOneName) {
  BarFile bar;
  bar.meshName = "upper";
  const AnimatedMesh mesh = readBar(bar, clipAt("bend", 2.0));
  const std::size_t tip = vertexAt(mesh, {0.0, 2.0, 0.0});
  EXPECT_LT((mesh.frames.back()[tip] - tipAt(std::numbers::pi / 2.0)).norm(), 1e-5);
}

TEST(AnimationImport, refusesSkinsWhoseVerticesFollowNoJoint) {
  BarFile bar;
  bar.joints = "[1]";
  const std::string missing = problemOf(bar, clipAt("bend", 2.0));
  EXPECT_NE(missing.find("vertex 2 of meshes[0].primitives[0] follows joint 1, and its skin has only 1"),
            std::string::npos)
      << missing;
  bar = {};
  bar.weight = 0.0F;
  const std::string still = problemOf(bar, clipAt("bend", 2.0));
  EXPECT_NE(still.find("6 of 6 vertices of meshes[0].primitives[0] follow no joint: all their weights are 0"),
            std::string::npos)
      << still;
}

TEST(AnimationImport, choosesTheClipByItsName) {
  const AnimatedMesh mesh = readBar({}, clipAt("still", 3.0));
  EXPECT_EQ(mesh.frames.size(), 7U);
  for (std::size_t v = 0; v < mesh.frames[0].size(); ++v) {
    EXPECT_LT((mesh.frames.back()[v] - mesh.frames.front()[v]).norm(), 1e-6);
  }
}

TEST(AnimationImport, tellsTheClipsWhenItCannotChoose) {
  EXPECT_TRUE(
      contains(problemOf({}, clipAt("", 10.0)), "there are several clips in it. Choose one of 'bend', 'still'"));
  EXPECT_TRUE(contains(problemOf({}, clipAt("jump", 10.0)), "there is no clip 'jump'. Choose one of 'bend', 'still'"));
}

TEST(AnimationImport, listsTheClipsOfAFileWithItsBindPose) {
  const Files files;
  BarFile bar;
  bar.upperPose = R"(, "rotation": [0, 0, 0.7071068, 0.7071068])";
  const BindPose pose = importBindPose(files.write("bar.gltf", bar.text()), {});
  EXPECT_EQ(pose.clips, (std::vector<ClipFacts>{{"bend", 2.0}, {"still", 2.0}}));
  EXPECT_NEAR(pose.mesh.summary.size[1], 2.0, 1e-6) << "it is straight";

  const BindPose fbx = importBindPose(std::filesystem::path(DRAPE_IO_TESTS_FOLDER) / "bar.fbx", {});
  const auto bend = std::ranges::find(fbx.clips, "bend", &ClipFacts::name);
  ASSERT_NE(bend, fbx.clips.end());
  EXPECT_NEAR(bend->duration, 2.0, 1e-6);
  EXPECT_NEAR(fbx.mesh.summary.size[1], 0.02, 1e-6) << "in metres";
}

TEST(AnimationImport, listsTheClipsBesideTheFramesOfOne) {
  EXPECT_EQ(readBar({}, clipAt("still", 3.0)).clips, (std::vector<ClipFacts>{{"bend", 2.0}, {"still", 2.0}}));
}

TEST(AnimationImport, listsNoClipThatCannotBePlayed) {
  BarFile bar;
  bar.times = {0.0F, 0.0F, 0.0F};
  const Files files;
  const BindPose pose = importBindPose(files.write("bar.gltf", bar.text()), {});
  EXPECT_TRUE(std::ranges::none_of(pose.clips, [](const ClipFacts& clip) { return clip.name == "bend"; }));
}

TEST(AnimationImport, scalesToMetres) {
  AnimationOptions options = clipAt("bend", 1.0);
  options.metresPerUnit = 0.01;
  EXPECT_LT(vertexAt(readBar({}, options), {0.01, 0.02, 0.0}), 6U);
}

TEST(AnimationImport, readsColladaInItsUnitWithYUp) {
  const Files files;
  AnimationOptions options;
  options.rate = 1.0;
  const AnimatedMesh upright = importAnimation(files.write("bar.dae", colladaBar("1", "Y_UP")), options);
  ASSERT_EQ(upright.frames.size(), 2U);
  EXPECT_DOUBLE_EQ(upright.frameTime, 1.0);
  EXPECT_LT((upright.frames[1][vertexAt(upright, {0.0, 2.0, 0.0})] - Vec3(-1.0, 1.0, 0.0)).norm(), 1e-5);
  EXPECT_LT((upright.frames[1][vertexAt(upright, {1.0, 0.0, 0.0})] - Vec3(1.0, 0.0, 0.0)).norm(), 1e-5);

  // z is up in this file, so its y points backwards.
  const AnimatedMesh lying = importAnimation(files.write("bar.dae", colladaBar("0.01", "Z_UP")), options);
  EXPECT_LT((lying.frames[1][vertexAt(lying, {0.0, 0.0, -0.02})] - Vec3(-0.01, 0.0, -0.01)).norm(), 1e-6);
}

TEST(AnimationImport, readsFbxInCentimetres) {
  const AnimatedMesh mesh =
      importAnimation(std::filesystem::path(DRAPE_IO_TESTS_FOLDER) / "bar.fbx", clipAt("bend", 2.0));
  ASSERT_EQ(mesh.frames.size(), 5U);
  EXPECT_NEAR(mesh.frameTime, 0.5, 1e-6);
  EXPECT_LT((mesh.frames[4][vertexAt(mesh, {0.0, 0.02, 0.0})] - Vec3(-0.01, 0.01, 0.0)).norm(), 1e-5);
}

TEST(AnimationImport, readsNoBufferOfAnotherFolder) {
  const Files files;
  std::string text = BarFile().text();
  const std::size_t start = text.find("data:application");
  const std::size_t end = text.find('"', start);
  const std::string elsewhere = text.substr(0, start) + "../bar.bin" + text.substr(end);
  EXPECT_TRUE(
      contains(inputErrorOf([&] { (void)importAnimation(files.write("bar.gltf", elsewhere), clipAt("bend", 2.0)); }),
               "only files beside it"));
}

TEST(AnimationImport, refusesKeysOutOfOrderAndAClipWithoutLength) {
  BarFile bar;
  bar.times = {0.0F, 1.5F, 1.0F};
  EXPECT_TRUE(contains(problemOf(bar, clipAt("bend", 10.0)), "the times of the keys of 'upper' do not ascend"));
  bar.times = {0.0F, 0.0F, 0.0F};
  EXPECT_TRUE(contains(problemOf(bar, clipAt("bend", 10.0)), "its clip 'bend' has no length"));
}

TEST(AnimationImport, refusesASkinWithoutBones) {
  BarFile bar;
  bar.joints = "[]";
  const std::string problem = problemOf(bar, clipAt("bend", 10.0));
  EXPECT_TRUE(contains(problem, "bar.gltf: the skin of meshes[0] has no joints")) << problem;
}

TEST(AnimationImport, refusesMoreFramesThanFitInMemory) {
  BarFile bar;
  bar.times = {0.0F, 1.0F, 599.0F};
  AnimationOptions options = clipAt("bend", 1e5);
  EXPECT_TRUE(contains(problemOf(bar, options), "Use a lower rate")) << problemOf(bar, options);
  bar.times = {0.0F, 1.0F, 700.0F};
  EXPECT_TRUE(contains(problemOf(bar, options), "the limit is 600 s"));
}

TEST(AnimationImport, refusesABodyOfTooManyTriangles) {
  BarFile bar;
  bar.layers = 75'001;
  EXPECT_TRUE(
      contains(problemOf(bar, clipAt("bend", 1.0)), "it has 300004 triangles, and a body that moves may have 300000"));
}

TEST(AnimationImport, namesTheFormatsForOtherFiles) {
  const Files files;
  EXPECT_TRUE(contains(inputErrorOf([&] { (void)importAnimation(files.write("bar.obj", "v 0 0 0"), {}); }),
                       "an animation is read from .glb, .gltf, .fbx, .dae"));
}

TEST(AnimationImport, survivesDamagedFiles) {
  const Files files;
  const std::string whole = BarFile().text();
  for (const char* name : {"bar.gltf", "bar.glb", "bar.fbx", "bar.dae"}) {
    for (const std::size_t size : {std::size_t{1}, whole.size() / 3, whole.size() - 5}) {
      const auto file = files.write(name, whole.substr(0, size));
      EXPECT_TRUE(contains(inputErrorOf([&] { (void)importAnimation(file, clipAt("bend", 10.0)); }), name)) << size;
    }
  }
}

}  // namespace
}  // namespace drape::io
