// Seams and elastic bands that the user adds to a running simulation.
#include "intersection/intersections.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "session/checkpoint.hpp"
#include "session/simulation.hpp"
#include "session/user_state.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace drape::session {
namespace {

constexpr const char* sideSeam = R"(
[[seams]]
from = { cloth = "front", vertices = [0, 36, 72] }
to = { cloth = "back", vertices = [8, 44, 80] }
)";

/// The pins of the second sheet along the side that is not sewn.
constexpr const char* pinnedSide = "pins = { edges = [\"left\"] }";

/// Two sheets without a seam, with these keys of the second one.
std::string apart(const std::string& lines) {
  return testing::twoSheets(lines) + "timeline.memory = 100\n";
}

std::shared_ptr<const scene::Scene> sheets(const std::string& lines = pinnedSide, const std::string& tables = "") {
  return testing::sceneFrom(apart(lines) + tables);
}

/// Adds a seam along a side of both sheets.
scene::Sewing withSeam(const Simulation& simulation, const std::vector<int>& front = {0, 36, 72},
                       const std::vector<int>& back = {8, 44, 80}) {
  scene::Sewing sewing = simulation.sewing();
  scene::SeamDescription& seam = sewing.seams.emplace_back();
  seam.sides = {scene::BorderDescription{"front", front, {}}, scene::BorderDescription{"back", back, {}}};
  return sewing;
}

bool isSewn(const Simulation& simulation, std::size_t seam = 0) {
  return sim::isWelded(simulation.cloth().seams()->at(seam), simulation.state().positions);
}

UserState userState(const Simulation& simulation) {
  Snapshot snapshot;
  simulation.capture(snapshot);
  return userStateOf(snapshot);
}

std::size_t crossingsOf(const Simulation& simulation) {
  return intersection::intersectingPairs({simulation.state().positions, simulation.model().triangles}).size();
}

TEST(RunningSeams, areDrawnTogetherOverASecondAndWelded) {
  Simulation simulation(sheets());
  testing::takeSteps(simulation, 60);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
  EXPECT_NEAR(simulation.cloth().seams()->front().start, 0.2, 1e-12);
  const auto gap = [&] { return (simulation.state().positions[36] - simulation.state().positions[81 + 44]).norm(); };
  const double before = gap();
  testing::takeSteps(simulation, 150);
  EXPECT_FALSE(isSewn(simulation));
  EXPECT_LT(gap(), 0.75 * before) << "half of the second is over";
  EXPECT_GT(gap(), 0.25 * before);
  testing::takeSteps(simulation, 230);
  EXPECT_TRUE(isSewn(simulation));
  testing::takeSteps(simulation, 100);
  EXPECT_EQ(crossingsOf(simulation), 0U);
}

TEST(RunningSeams, atTheStartAreThoseOfASceneFile) {
  Simulation written(sheets(pinnedSide, sideSeam));
  Simulation added(sheets());
  added.apply(SetSewingCommand{withSeam(added)});
  testing::takeSteps(written, 400);
  testing::takeSteps(added, 400);
  EXPECT_EQ(added.sewing(), written.sewing());
  EXPECT_EQ(sim::stateHash(added.state()), sim::stateHash(written.state()));
  EXPECT_TRUE(isSewn(added));
}

TEST(RunningSeams, stayAfterAResetAndStartThere) {
  Simulation written(sheets(pinnedSide, sideSeam));
  Simulation simulation(sheets());
  testing::takeSteps(simulation, 100);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  testing::takeSteps(simulation, 100);
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.cloth().seams()->front().start, 0.0);
  EXPECT_FALSE(isSewn(simulation));
  testing::takeSteps(simulation, 100);
  testing::takeSteps(written, 100);
  EXPECT_EQ(sim::stateHash(simulation.state()), sim::stateHash(written.state()));
}

TEST(RunningSeams, replayToTheSameBits) {
  Simulation simulation(sheets());
  testing::takeSteps(simulation, 40);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  testing::takeSteps(simulation, 380);
  EXPECT_TRUE(isSewn(simulation));
  simulation.apply(SetSewingCommand{scene::sewingOf(simulation.scene().description)});
  testing::takeSteps(simulation, 60);
  Simulation again(sheets());
  again.replay(simulation.log(), simulation.stepsTaken());
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(simulation.state()));
}

TEST(RunningSeams, openAgainWhereTheyWereWelded) {
  Simulation simulation(sheets(""));
  const UserState before = userState(simulation);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  const UserState after = userState(simulation);
  EXPECT_FALSE(areSame(before, after));
  testing::takeSteps(simulation, 500);
  ASSERT_TRUE(isSewn(simulation));
  for (const Command& command : commandsBetween(after, before, simulation.scene())) {
    simulation.apply(command);
  }
  EXPECT_TRUE(areSame(userState(simulation), before));
  EXPECT_TRUE(simulation.cloth().seams()->empty());
  EXPECT_EQ(simulation.cloth().model(), simulation.cloth().pieces());
  testing::takeSteps(simulation, 300);
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
  EXPECT_EQ(crossingsOf(simulation), 0U);
  EXPECT_GT((simulation.state().positions[72] - simulation.state().positions[81 + 80]).norm(), 0.02)
      << "the back falls from where it was sewn";
}

TEST(RunningSeams, areSewnAgainFromAnEarlierTime) {
  Simulation simulation(sheets());
  testing::takeSteps(simulation, 100);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  testing::takeSteps(simulation, 400);
  ASSERT_TRUE(isSewn(simulation));
  const auto hash = sim::stateHash(simulation.state());
  simulation.apply(GoToCommand{0.5});
  EXPECT_FALSE(isSewn(simulation));
  const int left = 500 - static_cast<int>(simulation.stepIndex());
  testing::takeSteps(simulation, left);
  EXPECT_EQ(sim::stateHash(simulation.state()), hash) << "the seam has the start that it had";
  simulation.apply(GoToCommand{0.1});
  EXPECT_DOUBLE_EQ(simulation.cloth().seams()->front().start, simulation.state().time) << "it was not there yet";
  testing::takeSteps(simulation, 400);
  EXPECT_TRUE(isSewn(simulation));
}

TEST(RunningSeams, belongToTheirCheckpoint) {
  Simulation simulation(sheets());
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  testing::takeSteps(simulation, 100);
  const std::string bytes = checkpointOf(simulation);
  testing::takeSteps(simulation, 300);
  Simulation without(sheets());
  EXPECT_THROW((void)continueFrom(bytes, without), messages::InputError);
  Simulation with(sheets());
  with.apply(SetSewingCommand{withSeam(with)});
  EXPECT_TRUE(continueFrom(bytes, with).empty());
  testing::takeSteps(with, 300);
  EXPECT_EQ(sim::stateHash(with.state()), sim::stateHash(simulation.state()));
}

TEST(RunningSeams, areSavedAndOpenToTheSameBits) {
  const auto original = sheets();
  Simulation simulation(original);
  testing::takeSteps(simulation, 50);
  scene::Sewing sewing = withSeam(simulation);
  sewing.seams.back().isReversed = true;
  sewing.bands[1].push_back({.length = 0.7, .vertices = {72, 76, 80}});
  simulation.apply(SetSewingCommand{sewing});
  EXPECT_TRUE(simulation.message().empty()) << simulation.message();
  scene::SceneNow now = scene::unchanged(*original);
  now.sewing = simulation.sewing();
  const std::string text = scene::writeScene(*original, now, std::filesystem::current_path()).text;
  Simulation saved(testing::sceneFrom(text));
  EXPECT_EQ(saved.sewing(), simulation.sewing()) << text;
  simulation.apply(ResetCommand{});
  testing::takeSteps(simulation, 150);
  testing::takeSteps(saved, 150);
  EXPECT_EQ(sim::stateHash(saved.state()), sim::stateHash(simulation.state())) << text;
}

TEST(RunningSeams, areRefusedWithAReasonAndChangeNothing) {
  Simulation simulation(sheets());
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  const scene::Sewing accepted = simulation.sewing();
  const auto expectRefused = [&](const scene::Sewing& sewing, const std::string& words) {
    simulation.apply(SetSewingCommand{sewing});
    EXPECT_NE(simulation.message().english().find(words), std::string::npos) << simulation.message();
    EXPECT_EQ(simulation.sewing(), accepted);
    EXPECT_EQ(simulation.cloth().seams()->size(), 1U);
  };
  expectRefused(withSeam(simulation, {0, 40, 72}, {8, 44, 80}), "not on the same open border");
  expectRefused(withSeam(simulation, {0, 36, 72}, {80, 44, 99}), "there is no vertex 99 in the cloth \"back\"");
  expectRefused(withSeam(simulation, {0}, {8, 44, 80}), "whole border");
  expectRefused(withSeam(simulation, {72, 36, 0}, {80, 44, 8}), "join these vertices already");
  scene::Sewing odd = withSeam(simulation, {0, 4, 8}, {0, 4, 8});
  odd.seams.back().duration = 0.0;
  expectRefused(odd, "duration");
  odd = accepted;
  odd.bands[0].push_back({.length = 2.0, .vertices = {0}});
  expectRefused(odd, "length of an elastic band must be from 0.3 to 1.5");
  odd.bands[0] = {{.length = 0.9, .vertices = {0}}, {.length = 0.8, .vertices = {0, 4, 8}}};
  expectRefused(odd, "an elastic band along this border already");
  odd.bands.pop_back();
  expectRefused(odd, "each cloth");
}

TEST(RunningSeams, areRefusedBetweenFabricsAndPins) {
  Simulation fabrics(sheets("settings = { \"material.preset\" = \"denim\" }"));
  fabrics.apply(SetSewingCommand{withSeam(fabrics)});
  EXPECT_NE(fabrics.message().english().find("different materials"), std::string::npos) << fabrics.message();
  EXPECT_TRUE(fabrics.cloth().seams()->empty());
  Simulation pinned(sheets("pins = { corners = [\"top_left\", \"top_right\"] }"));
  pinned.apply(SetSewingCommand{withSeam(pinned)});
  EXPECT_NE(pinned.message().english().find("are both pinned"), std::string::npos) << pinned.message();
}

TEST(RunningSeams, ofADartLeaveItsTipAlone) {
  Simulation simulation(sheets());
  scene::Sewing sewing = simulation.sewing();
  scene::SeamDescription& seam = sewing.seams.emplace_back();  // two sides of one sheet with a common corner
  seam.sides = {scene::BorderDescription{"back", {8, 4, 0}, {}}, scene::BorderDescription{"back", {80, 44, 8}, {}}};
  seam.isReversed = true;
  simulation.apply(SetSewingCommand{sewing});
  const bool isRefused = !simulation.message().empty();
  EXPECT_TRUE(!isRefused || simulation.message().english().find("two corners of one triangle") != std::string::npos)
      << simulation.message();
  EXPECT_EQ(simulation.message().english().find("sewn to itself"), std::string::npos);
}

TEST(RunningSeams, openAndCloseInTheGhostToo) {
  const auto scene = sheets();
  Simulation simulation(scene);
  simulation.apply(SetSettingCommand{"ghost.solver", std::string("auto")});
  testing::takeSteps(simulation, 20);
  simulation.apply(SetSewingCommand{withSeam(simulation)});
  testing::takeSteps(simulation, 380);
  ASSERT_NE(simulation.ghost(), nullptr);
  EXPECT_TRUE(sim::isWelded(simulation.cloth().seams()->front(), simulation.ghost()->state().positions));
  const sim::Seam seam = simulation.cloth().seams()->front();
  simulation.apply(SetSewingCommand{scene::sewingOf(scene->description)});
  testing::takeSteps(simulation, 60);
  ASSERT_NE(simulation.ghost(), nullptr);
  EXPECT_FALSE(sim::isWelded(seam, simulation.ghost()->state().positions));
}

constexpr const char* fabric = "\"fabric\"\nmaterial.preset = \"cotton\"";

/// The material of the sheets: springs or a fabric.
class RunningBands : public ::testing::TestWithParam<const char*> {
 protected:
  static std::shared_ptr<const scene::Scene> sheetsOf(const std::string& lines = "") {
    std::string text = apart(lines);
    text.replace(text.find(fabric), std::string(fabric).size(), GetParam());
    return testing::sceneFrom(text);
  }
};

TEST_P(RunningBands, areThoseOfASceneFile) {
  Simulation written(sheetsOf("bands = [{ vertices = [0], length = 0.7 }]"));
  Simulation added(sheetsOf());
  scene::Sewing sewing = added.sewing();
  sewing.bands[1].push_back({.length = 0.7, .vertices = {0}});
  added.apply(SetSewingCommand{sewing});
  EXPECT_TRUE(added.message().empty()) << added.message();
  testing::takeSteps(written, 60);
  testing::takeSteps(added, 60);
  EXPECT_EQ(added.sewing(), written.sewing());
  EXPECT_EQ(sim::stateHash(added.state()), sim::stateHash(written.state()));
}

TEST_P(RunningBands, changeAndGo) {
  const auto scene = sheetsOf();
  Simulation plain(scene);
  Simulation simulation(scene);
  scene::Sewing sewing = simulation.sewing();
  for (const double length : {0.7, 0.9}) {
    sewing.bands[0] = {{.length = length, .vertices = {0, 4, 8}}};
    simulation.apply(SetSewingCommand{sewing});
    const sim::ClothModel& model = simulation.model();
    const int along = sim::springBetween(model.springEnds, 0, 1);
    EXPECT_NEAR(model.springs[along].restLength, length * 0.05, 1e-12);
  }
  sewing.bands[0].clear();
  simulation.apply(SetSewingCommand{sewing});
  testing::takeSteps(plain, 60);
  testing::takeSteps(simulation, 60);
  EXPECT_EQ(sim::stateHash(simulation.state()), sim::stateHash(plain.state()));
}

TEST_P(RunningBands, stayWhenTheMaterialChanges) {
  Simulation simulation(sheetsOf());
  scene::Sewing sewing = simulation.sewing();
  sewing.bands[0] = {{.length = 0.7, .vertices = {0}}};
  simulation.apply(SetSewingCommand{sewing});
  simulation.apply(SetSettingCommand{"material.model", std::string("springs")});
  const sim::ClothModel& model = simulation.model();
  EXPECT_NEAR(model.springs[sim::springBetween(model.springEnds, 0, 1)].restLength, 0.7 * 0.05, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Materials, RunningBands, ::testing::Values("\"springs\"", fabric),
                         [](const auto& each) { return std::string(each.index == 0 ? "springs" : "fabric"); });

}  // namespace
}  // namespace drape::session
