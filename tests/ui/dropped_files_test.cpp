#include "ui/dropped_files.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

TEST(DroppedFiles, AreSortedByTheirEndings) {
  const DroppedFiles files = sortDropped({"/a/Coat.OBJ", "/a/room.toml", "/a/notes.txt", "/a/body.stl"});
  EXPECT_EQ(files.meshes, (std::vector<std::string>{"/a/Coat.OBJ", "/a/body.stl"}));
  EXPECT_EQ(files.scenes, (std::vector<std::string>{"/a/room.toml"}));
  EXPECT_EQ(files.others, (std::vector<std::string>{"/a/notes.txt"}));
}

TEST(DroppedFiles, OneMeshOrOneSceneIsOpenedAtOnce) {
  for (const char* file : {"/a/coat.obj", "/a/room.toml"}) {
    const DropDecision decision = decide(sortDropped({file}));
    ASSERT_TRUE(decision.open) << file;
    EXPECT_EQ(decision.open->scene, file);
    EXPECT_FALSE(decision.ask);
    EXPECT_TRUE(decision.notice.empty());
  }
}

TEST(DroppedFiles, OfSeveralScenesTheLastIsOpenedAndTheOthersAreNamed) {
  const DropDecision decision = decide(sortDropped({"/a/one.toml", "/a/two.toml", "/a/three.toml"}));
  ASSERT_TRUE(decision.open);
  EXPECT_EQ(decision.open->scene, "/a/three.toml");
  EXPECT_NE(decision.notice.english().find("one.toml"), std::string::npos) << decision.notice;
  EXPECT_NE(decision.notice.english().find("two.toml"), std::string::npos) << decision.notice;
}

TEST(DroppedFiles, AStrangerBesideAMeshIsNamed) {
  const DropDecision decision = decide(sortDropped({"/a/coat.obj", "/a/notes.txt"}));
  ASSERT_TRUE(decision.open);
  EXPECT_EQ(decision.open->scene, "/a/coat.obj");
  EXPECT_NE(decision.notice.english().find("notes.txt"), std::string::npos) << decision.notice;
}

TEST(DroppedFiles, StrangersAloneAreOpenedForTheMessageAndTheRestNamed) {
  const DropDecision decision = decide(sortDropped({"/a/notes.txt", "/a/photo.jpg"}));
  ASSERT_TRUE(decision.open);
  EXPECT_EQ(decision.open->scene, "/a/notes.txt");
  EXPECT_NE(decision.notice.english().find("photo.jpg"), std::string::npos) << decision.notice;
}

TEST(DroppedFiles, SeveralMeshesRaiseTheQuestion) {
  const DroppedFiles files = sortDropped({"/a/Female_Body.obj", "/a/coat.obj", "/a/shoe.ply"});
  const DropDecision decision = decide(files);
  EXPECT_TRUE(decision.ask);
  EXPECT_FALSE(decision.open);
  EXPECT_EQ(likelyCloth(files), 1U) << "what is called a body is none";
  const scene::SceneParts parts = partsWithCloth(files, 1);
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/Female_Body.obj", "/a/shoe.ply"}));
  EXPECT_TRUE(parts.scene.empty());
}

TEST(DroppedFiles, AVertexCacheMakesItsMeshABody) {
  const DroppedFiles files = sortDropped({"/a/runner.obj", "/a/coat.obj", "/a/runner.PC2"});
  EXPECT_EQ(files.caches, (std::vector<std::string>{"/a/runner.PC2"}));
  EXPECT_TRUE(decide(files).ask);
  EXPECT_EQ(likelyCloth(files), 1U);
  const scene::SceneParts parts = partsWithCloth(files, 1);
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/runner.obj"}));
  EXPECT_EQ(parts.caches, (std::vector<std::string>{"/a/runner.PC2"}));
  for (const DroppedFiles& alone : {sortDropped({"/a/runner.pc2"}), sortDropped({"/a/coat.obj", "/a/runner.mdd"})}) {
    EXPECT_NE(decide(alone).notice.english().find("drop garment, body and runner."), std::string::npos)
        << decide(alone).notice;
  }
}

TEST(DroppedFiles, ASceneAndAMeshRaiseTheQuestionAndKeepTheScenesCloth) {
  const DroppedFiles files = sortDropped({"/a/room.toml", "/a/table.obj"});
  EXPECT_TRUE(decide(files).ask);
  const scene::SceneParts parts = partsWithCloth(files, likelyCloth(files));
  EXPECT_EQ(parts.scene, "/a/room.toml");
  EXPECT_TRUE(parts.cloth.empty());
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/table.obj"}));
  EXPECT_EQ(partsWithCloth(files, 0).cloth, "/a/table.obj");
}

TEST(DroppedFiles, OfTheSameNameAreDistinguishedByTheirFolders) {
  EXPECT_EQ(distinctNames({"/a/summer/coat.obj", "/a/winter/coat.obj", "/a/body.obj"}),
            (std::vector<std::string>{"coat.obj (summer)", "coat.obj (winter)", "body.obj"}));
}

/// A garment that was opened from a file.
scene::SceneDescription openedGarment() {
  scene::SceneDescription scene;
  scene.opened = true;
  scene.parts.scene = "/a/coat.obj";
  return scene;
}

scene::BodyDescription meshBody() {
  scene::BodyDescription body;
  body.meshes = {{"figure.obj", true}};
  return body;
}

TEST(DroppedFiles, ABodyGoesWithTheGarmentThatIsOpen) {
  const DroppedFiles files = joinedWith(openedGarment(), sortDropped({"/a/mannequin.obj"}));
  EXPECT_EQ(files.alone, "/a/mannequin.obj");
  EXPECT_TRUE(decide(files).ask);
  const scene::SceneParts parts = partsWithCloth(files, likelyCloth(files));
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/mannequin.obj"}));
}

TEST(DroppedFiles, AGarmentGoesWithTheBodyOfTheScene) {
  scene::SceneDescription present;
  present.parts.scene = "walk";
  present.bodies = {meshBody()};
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/coat.obj"}));
  EXPECT_TRUE(decide(files).ask);
  const scene::SceneParts parts = partsWithCloth(files, likelyCloth(files));
  EXPECT_EQ(parts.scene, "walk");
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
}

TEST(DroppedFiles, AnotherGarmentGoesWithTheBodyThatWasOpenedWithTheFirst) {
  scene::SceneDescription present = openedGarment();
  present.parts = {.cloth = "/a/coat.obj", .bodies = {"mannequin"}, .dressed = true};
  present.bodies = {meshBody()};
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/shirt.obj"}));
  const scene::SceneParts parts = partsWithCloth(files, likelyCloth(files));
  EXPECT_TRUE(parts.scene.empty());
  EXPECT_EQ(parts.cloth, "/a/shirt.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"mannequin"}));
}

TEST(DroppedFiles, AGarmentAfterAGarmentIsOpenedAtOnce) {
  EXPECT_TRUE(decide(joinedWith(openedGarment(), sortDropped({"/a/shirt.obj"}))).open);
  scene::SceneDescription bare;
  bare.parts.scene = "flag";
  EXPECT_TRUE(decide(joinedWith(bare, sortDropped({"/a/shirt.obj"}))).open);
  EXPECT_TRUE(decide(joinedWith(bare, sortDropped({"/a/body.obj"}))).open);
}

}  // namespace
}  // namespace drape::ui
