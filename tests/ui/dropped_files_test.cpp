#include "ui/dropped_files.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

scene::FoundMesh figure(std::vector<io::ClipFacts> clips) {
  scene::FoundMesh found{.format = {1.0, 'y'}, .extent = {1.0, 1.7, 0.4}, .upOfShape = "y"};
  found.clips = std::move(clips);
  return found;
}

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

/// A garment that was opened from a file in centimetres.
scene::Scene openedGarment() {
  scene::Scene scene;
  scene.description.opened = true;
  scene.description.parts.scene = "/a/coat.obj";
  scene.description.cloth().source = scene::MeshFileSource{"/a/coat.obj", false};
  scene.settings.mesh.unit = "cm";
  scene.settings.mesh.up = "auto";
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
  const DropChoices choices = firstChoices(files);
  EXPECT_EQ(choices.readings, (std::vector<scene::ReadingChoice>{{"cm", "auto"}, {"auto", "auto"}}))
      << "the garment stays as it is read now";
  const scene::SceneParts parts = partsBy(files, choices, {});
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/mannequin.obj"}));
  EXPECT_EQ(parts.clothReading, (scene::ReadingChoice{"cm", "auto"}));
}

TEST(DroppedFiles, AMeshOfAnotherNameMayTurnOutToBeABody) {
  const DroppedFiles dropped = sortDropped({"/a/anna.obj"});
  EXPECT_TRUE(decide(joinedWith(openedGarment(), dropped)).open) << "its name does not say so";
  const std::optional<DroppedFiles> files = joinedIfBody(openedGarment(), dropped);
  ASSERT_TRUE(files);
  EXPECT_EQ(files->alone, "/a/anna.obj");
  EXPECT_EQ(partsBy(*files, firstChoices(*files), {}).bodies, (std::vector<std::string>{"/a/anna.obj"}));
  EXPECT_FALSE(joinedIfBody(openedGarment(), sortDropped({"/a/coat.obj"}))) << "the garment itself";
  EXPECT_FALSE(joinedIfBody(scene::Scene(), dropped)) << "there is no garment";
}

TEST(DroppedFiles, AGarmentGoesOnAFigureWithBonesThatWasOpenedAlone) {
  scene::Scene present = openedGarment();
  present.description.parts = {.scene = "/a/anna.glb"};
  present.summary.hasSkin = true;
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/shirt.obj"}));
  EXPECT_TRUE(decide(files).ask);
  const scene::SceneParts parts = partsBy(files, firstChoices(files), {});
  EXPECT_EQ(parts.cloth, "/a/shirt.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/anna.glb"}));
  EXPECT_FALSE(joinedIfBody(present, sortDropped({"/a/shirt.obj"}))) << "it goes on the figure already";
}

TEST(DroppedFiles, ANameWithTheWordOfAGarmentIsNoBody) {
  EXPECT_EQ(likelyCloth(sortDropped({"/a/anna.obj", "/a/avatar_tshirt.obj"})), 0U);
  EXPECT_EQ(likelyCloth(sortDropped({"/a/avatar.obj", "/a/avatar_tshirt.obj"})), 1U);
  scene::Scene present = openedGarment();
  present.description.parts = {.scene = "/a/anna.glb"};
  present.summary.hasSkin = true;
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/avatar_tshirt.obj"}));
  EXPECT_EQ(partsBy(files, firstChoices(files), {}).cloth, "/a/avatar_tshirt.obj");
}

TEST(DroppedFiles, AGarmentGoesWithTheBodyOfTheScene) {
  scene::Scene present;
  present.description.parts.scene = "walk";
  present.description.bodies = {meshBody()};
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/coat.obj"}));
  EXPECT_TRUE(decide(files).ask);
  const scene::SceneParts parts = partsWithCloth(files, likelyCloth(files));
  EXPECT_EQ(parts.scene, "walk");
  EXPECT_EQ(parts.cloth, "/a/coat.obj");
}

TEST(DroppedFiles, AnotherGarmentGoesWithTheBodyThatWasOpenedWithTheFirst) {
  scene::Scene present = openedGarment();
  present.description.parts = {.cloth = "/a/coat.obj", .bodies = {"/a/person.obj"}, .dressed = true};
  present.description.bodies = {meshBody()};
  present.description.parts.bodyClips = {std::nullopt};
  present.description.bodies.front().reading = scene::ReadingChoice{"mm", "z"};
  const DroppedFiles files = joinedWith(present, sortDropped({"/a/shirt.obj"}));
  const scene::SceneParts parts = partsBy(files, firstChoices(files), {});
  EXPECT_TRUE(parts.scene.empty());
  EXPECT_EQ(parts.cloth, "/a/shirt.obj");
  EXPECT_EQ(parts.bodies, (std::vector<std::string>{"/a/person.obj"}));
  EXPECT_EQ(parts.clothReading, scene::ReadingChoice());
  EXPECT_EQ(parts.bodyReadings, (std::vector<scene::ReadingChoice>{{"mm", "z"}})) << "the body stays as it is";
  present.description.parts.bodyClips = {"run"};
  const DroppedFiles moving = joinedWith(present, sortDropped({"/a/shirt.obj"}));
  const std::vector<FoundFile> found{{"/a/person.obj", figure({{"walk", 1.2}, {"run", 0.8}}), {}}};
  EXPECT_EQ(clipBy(moving, firstChoices(moving), 1, found), "run") << "it still moves as it did";
}

TEST(DroppedFiles, AGarmentAfterAGarmentIsOpenedAtOnce) {
  EXPECT_TRUE(decide(joinedWith(openedGarment(), sortDropped({"/a/shirt.obj"}))).open);
  scene::Scene bare;
  bare.description.parts.scene = "flag";
  EXPECT_TRUE(decide(joinedWith(bare, sortDropped({"/a/shirt.obj"}))).open);
  EXPECT_TRUE(decide(joinedWith(bare, sortDropped({"/a/body.obj"}))).open);
}

TEST(DroppedFiles, TheOnlyClipOfABodyMovesItAndOneOfSeveralIsChosen) {
  const DroppedFiles files = sortDropped({"/a/coat.obj", "/a/body.glb"});
  std::vector<FoundFile> found{{"/a/coat.obj", figure({}), {}}, {"/a/body.glb", figure({{"walk", 1.2}}), {}}};
  DropChoices choices = firstChoices(files);
  EXPECT_EQ(partsBy(files, choices, found).bodyClips, (std::vector<std::optional<std::string>>{"walk"}));
  choices.motions[1] = {true, std::nullopt};
  EXPECT_EQ(partsBy(files, choices, found).bodyClips, (std::vector<std::optional<std::string>>{std::nullopt}))
      << "the user wants it to stand";
  found[1].mesh = figure({{"walk", 1.2}, {"run", 0.8}});
  EXPECT_FALSE(clipBy(files, firstChoices(files), 1, found)) << "which one is not known";
  choices.motions[1] = {true, "run"};
  const scene::SceneParts parts = partsBy(files, choices, found);
  EXPECT_EQ(parts.bodyClips, (std::vector<std::optional<std::string>>{"run"}));
  EXPECT_EQ(parts.bodyReadings, (std::vector<scene::ReadingChoice>{{}})) << "its file states unit and up axis";
  EXPECT_FALSE(clipBy(files, choices, 0, found)) << "it is the cloth";
}

TEST(DroppedFiles, AFormatOfAnimationsAloneIsABodyThatMoves) {
  const DroppedFiles files = sortDropped({"/a/anna.fbx", "/a/coat.obj"});
  EXPECT_EQ(likelyCloth(files), 1U);
  scene::FoundMesh anna = figure({{"walk", 1.2}, {"run", 0.8}});
  anna.isOnlyAnimation = true;
  const std::vector<FoundFile> found{{"/a/anna.fbx", anna, {}}, {"/a/coat.obj", figure({}), {}}};
  EXPECT_EQ(partsBy(files, firstChoices(files), found).bodyClips, (std::vector<std::optional<std::string>>{"walk"}));
  const DroppedFiles joined = joinedWith(openedGarment(), sortDropped({"/a/anna.fbx"}));
  EXPECT_EQ(joined.meshes, (std::vector<std::string>{"/a/coat.obj", "/a/anna.fbx"}))
      << "with the garment in the window";
}

TEST(DroppedFiles, ABodyWithoutAGarmentIsNotOpenedAndTheNoticeSaysWhatToDo) {
  const DropDecision decision = decide(sortDropped({"/a/anna.fbx"}));
  EXPECT_FALSE(decision.open);
  EXPECT_FALSE(decision.ask);
  EXPECT_NE(decision.notice.english().find("anna.fbx is a body: drop it together with a garment"), std::string::npos)
      << decision.notice.english();
}

TEST(DroppedFiles, AreReadAsTheUserSees) {
  const DroppedFiles files = sortDropped({"/a/body.obj", "/a/coat.obj"});
  const scene::FoundMesh person{.extent = {100.0, 40.0, 170.0}, .upOfShape = "z"};
  const scene::FoundMesh coat{.extent = {30.0, 28.0, 12.0}, .upOfShape = "y"};
  std::vector<FoundFile> found{{"/a/body.obj", person, {}}, {"/a/coat.obj", std::nullopt, {}}};
  DropChoices choices = firstChoices(files);
  ASSERT_EQ(choices.cloth, 1U);
  EXPECT_FALSE(readingsBy(files, choices, found)[1]) << "its file is not read yet";
  EXPECT_FALSE(readingsBy(files, choices, found)[0]) << "it may follow the cloth";
  found[1].mesh = coat;
  choices.readings[1].unit = "inch";
  const auto readings = readingsBy(files, choices, found);
  ASSERT_TRUE(readings[0] && readings[1]);
  EXPECT_EQ(readings[0]->unit, "cm");
  EXPECT_EQ(readings[0]->up, "z");
  EXPECT_NEAR(readings[0]->size[1], 1.7, 1e-12);
  EXPECT_NEAR(readings[1]->size[0], 30.0 * 0.0254, 1e-12);
  const scene::SceneParts parts = partsBy(files, choices, found);
  EXPECT_EQ(parts.clothReading, (scene::ReadingChoice{"inch", "y"}));
  EXPECT_EQ(parts.bodyReadings, (std::vector<scene::ReadingChoice>{{"cm", "z"}}));
}

}  // namespace
}  // namespace drape::ui
