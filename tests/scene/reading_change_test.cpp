// Another unit or up axis of a cloth or a body that is in the scene already.
#include "scene/reading_change.hpp"

#include "garment_shapes.hpp"
#include "messages/error.hpp"
#include "scene/scene_parts.hpp"
#include "sim/contact/bodies/motion.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

namespace drape::scene {
namespace {

constexpr Placeable cloth{Placeable::Kind::Cloth, 0};
constexpr Placeable body{Placeable::Kind::Body, 0};

/// A shirt and a person in centimetres with z up.
class ReadingChangeTest : public ::testing::Test {
 protected:
  ReadingChangeTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("shirt.obj", testing::shirt({}));
    write("person.obj", testing::figure(45.0));
    const SceneDescription description = openParts(
        {.cloth = (folder_ / "shirt.obj").string(), .bodies = {(folder_ / "person.obj").string()}, .dressed = true});
    scene_ = buildScene(description, description.settings);
  }
  ~ReadingChangeTest() override { std::filesystem::remove_all(folder_); }

  void write(const char* name, const sim::ClothMesh& mesh) const {
    std::ofstream(folder_ / name) << testing::objText(testing::scaled(testing::withZUp(mesh), 100.0));
  }

  [[nodiscard]] static Eigen::AlignedBox3d boxOf(const Scene& scene, const Placeable& thing) {
    if (thing == cloth) {
      return sim::boundsOf(scene.start.positions);
    }
    const sim::contact::Body& shown = scene.bodies->front();
    std::vector<Vec3> positions = sim::contact::surfaceOf(shown.shape).positions;
    const sim::contact::Pose pose = sim::contact::poseAt(shown.motion, 0.0);
    for (Vec3& position : positions) {
      position = pose.toWorld(position);
    }
    return sim::boundsOf(positions);
  }

  /// The scene with another reading of a thing that is not placed.
  [[nodiscard]] std::shared_ptr<const Scene> readAs(const Placeable& thing, const ReadingChoice& to) const {
    ReadingChange change = withReading(*scene_, thing, to, boxOf(*scene_, thing).center(),
                                       {scene_->settings, placementsOf(scene_->description)});
    return buildScene(withPlacements(scene_->description, change.placements), change.settings);
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::shared_ptr<const Scene> scene_;
};

TEST_F(ReadingChangeTest, BothAreReadInTheirOwnUnit) {
  EXPECT_EQ(changeableReading(*scene_, cloth), (ReadingChoice{"cm", "z"}));
  EXPECT_EQ(changeableReading(*scene_, body), (ReadingChoice{"cm", "z"}));
  EXPECT_NEAR(boxOf(*scene_, body).sizes().y(), 1.7, 0.1) << "a person, and no tower";
  EXPECT_NEAR(boxOf(*scene_, cloth).sizes().y(), 0.7, 0.05);
}

TEST_F(ReadingChangeTest, AnotherUnitChangesTheSizeAndKeepsTheMiddle) {
  for (const Placeable& thing : {cloth, body}) {
    const Eigen::AlignedBox3d before = boxOf(*scene_, thing);
    const auto changed = readAs(thing, {"inch", "z"});
    const Eigen::AlignedBox3d after = boxOf(*changed, thing);
    EXPECT_LT((after.sizes() - 2.54 * before.sizes()).norm(), 1e-6);
    EXPECT_LT((after.center() - before.center()).norm(), 1e-5);
    EXPECT_EQ(changeableReading(*changed, thing), (ReadingChoice{"inch", "z"}));
  }
}

TEST_F(ReadingChangeTest, AnotherUpAxisTurnsItAndKeepsTheMiddle) {
  for (const Placeable& thing : {cloth, body}) {
    const Eigen::AlignedBox3d before = boxOf(*scene_, thing);
    const Eigen::AlignedBox3d after = boxOf(*readAs(thing, {"cm", "y"}), thing);
    EXPECT_NEAR(after.sizes().y(), before.sizes().z(), 1e-6) << "what was deep is tall";
    EXPECT_NEAR(after.sizes().z(), before.sizes().y(), 1e-6);
    EXPECT_LT((after.center() - before.center()).norm(), 1e-5);
  }
}

TEST_F(ReadingChangeTest, TheFormerPlacementsTakeItBack) {
  const auto changed = readAs(body, {"mm", "y"});
  const auto back =
      buildScene(withPlacements(changed->description, placementsOf(scene_->description)), scene_->settings);
  EXPECT_LT((boxOf(*back, body).min() - boxOf(*scene_, body).min()).norm(), 1e-12);
  EXPECT_LT((boxOf(*back, body).max() - boxOf(*scene_, body).max()).norm(), 1e-12);
  EXPECT_EQ(placementsOf(back->description), writtenPlacementsOf(changed->description)) << "as it was opened";
}

TEST_F(ReadingChangeTest, ABodyThatIsReadLikeTheClothCanGetItsOwnUnit) {
  const SceneDescription description =
      openParts({.cloth = (folder_ / "shirt.obj").string(), .bodies = {(folder_ / "person.obj").string()}});
  ASSERT_TRUE(description.bodies.front().readLikeCloth);
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(changeableReading(*scene, body), (ReadingChoice{"cm", "z"}));
}

TEST_F(ReadingChangeTest, TheUserCanChooseThemBeforeTheFilesAreOpened) {
  const SceneDescription description = openParts({.cloth = (folder_ / "shirt.obj").string(),
                                                  .bodies = {(folder_ / "person.obj").string()},
                                                  .clothReading = {"inch", "y"},
                                                  .bodyReadings = {{"mm", "auto"}}});
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(changeableReading(*scene, cloth), (ReadingChoice{"inch", "y"}));
  EXPECT_EQ(changeableReading(*scene, body), (ReadingChoice{"mm", "z"})) << "what is not chosen is guessed";
}

TEST_F(ReadingChangeTest, AnUnknownUnitIsRefused) {
  Placements placements = placementsOf(scene_->description);
  placements.readings.front() = ReadingChoice{"parsec", "y"};
  EXPECT_THROW(static_cast<void>(withPlacements(scene_->description, placements)), messages::InputError);
}

TEST(ChangeableReading, ShapesAndBuiltInMeshesHaveNone) {
  const SceneDescription sphere = openScene("sphere");
  const auto scene = buildScene(sphere, sphere.settings);
  EXPECT_FALSE(changeableReading(*scene, cloth));
  EXPECT_FALSE(changeableReading(*scene, body));
}

}  // namespace
}  // namespace drape::scene
