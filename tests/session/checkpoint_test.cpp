#include "session/checkpoint.hpp"

#include "messages/error.hpp"
#include "sim/checkpoint/state_bytes.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace drape::session {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

std::shared_ptr<const scene::Scene> built(const std::string& name, const Values& values) {
  const scene::SceneDescription description = scene::openScene(name);
  settings::Settings settings = description.settings;
  for (const auto& [key, value] : values) {
    settings::assignSettingText(settings, settings::requireSetting(key), value);
  }
  return scene::buildScene(description, settings);
}

/// What the state must remember at the checkpoint, so that a test proves something.
enum class Remembers { Anything, SelfContact, Sleep };

struct Case {
  std::string scene;
  Values values;
  int before;
  int after;
  Remembers remembers = Remembers::Anything;
};

bool sleeps(const Simulation& simulation) {
  const auto& choice = simulation.lastStepReport().choice;
  return choice && choice->sleeping;
}

class Checkpoint : public ::testing::TestWithParam<Case> {};

TEST_P(Checkpoint, continuesToTheSameBits) {
  const Case& test = GetParam();
  const auto scene = built(test.scene, test.values);
  Simulation whole(scene);
  testing::takeSteps(whole, test.before);
  EXPECT_TRUE(test.remembers != Remembers::SelfContact || whole.state().selfContact != nullptr);
  EXPECT_TRUE(test.remembers != Remembers::Sleep || sleeps(whole));
  const std::string bytes = checkpointOf(whole);
  testing::takeSteps(whole, test.after);

  Simulation resumed(scene);
  EXPECT_TRUE(continueFrom(bytes, resumed).empty());
  EXPECT_EQ(resumed.stepIndex(), test.before);
  EXPECT_EQ(checkpointOf(resumed), bytes) << "nothing is lost";
  testing::takeSteps(resumed, test.after);
  EXPECT_EQ(sim::toHex(sim::stateHash(resumed.state())), sim::toHex(sim::stateHash(whole.state())));
  EXPECT_EQ(checkpointOf(resumed), checkpointOf(whole)) << "the memory of the solver too";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Checkpoint,
    ::testing::Values(
        Case{"grid", {}, 40, 40}, Case{"grid", {{"integration", "bdf2"}, {"solver", "pcg"}}, 20, 20},
        // The cloth falls asleep before the checkpoint, and stays asleep.
        Case{"falling_sheet",
             {{"solver", "auto"}, {"grid.resolution", "9"}, {"stiffness", "200"}, {"damping", "0.1"}, {"drag", "1"}},
             1200,
             20,
             Remembers::Sleep},
        // Exact self-collision, and that with the hash.
        Case{"fold", {{"grid.resolution", "25"}}, 90, 40, Remembers::SelfContact},
        Case{"fold", {{"grid.resolution", "25"}, {"cloth_thickness", "0.02"}}, 90, 40, Remembers::SelfContact},
        Case{"fold", {{"grid.resolution", "25"}, {"self_collision", "hash"}}, 90, 40, Remembers::SelfContact},
        Case{"falling_sheet", {{"grid.resolution", "21"}, {"self_collision", "hash"}}, 90, 40, Remembers::SelfContact},
        // Bodies that move, with a fabric.
        Case{"turning_sphere", {{"grid.resolution", "21"}}, 90, 40},
        Case{"table_runner", {{"grid.resolution", "11"}}, 60, 30}));

std::string messageOf(const std::string& bytes, Simulation& simulation) {
  try {
    (void)continueFrom(bytes, simulation);
  } catch (const messages::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckpointFile, refusesWhatIsNotACheckpointOfThisScene) {
  Simulation simulation(built("grid", {{"grid.resolution", "9"}}));
  testing::takeSteps(simulation, 3);
  const std::string bytes = checkpointOf(simulation);
  Simulation fresh(built("grid", {{"grid.resolution", "9"}}));
  const auto before = sim::stateHash(fresh.state());
  EXPECT_NE(messageOf("", fresh).find("not a checkpoint"), std::string::npos);
  EXPECT_NE(messageOf("solid cube", fresh).find("not a checkpoint"), std::string::npos);
  for (const std::size_t length : {std::size_t{8}, std::size_t{30}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_NE(messageOf(bytes.substr(0, length), fresh).find("damaged"), std::string::npos) << length;
  }
  EXPECT_NE(messageOf(bytes + "x", fresh).find("damaged"), std::string::npos);
  for (std::size_t at = 32; at < bytes.size(); at += 997) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    EXPECT_NE(messageOf(damaged, fresh).find("damaged"), std::string::npos) << at;
  }
  std::string newer = bytes;
  newer[16] = 99;
  EXPECT_NE(messageOf(newer, fresh).find("version 99"), std::string::npos);
  EXPECT_EQ(sim::stateHash(fresh.state()), before);
  Simulation other(built("grid", {{"grid.resolution", "10"}}));
  EXPECT_NE(messageOf(bytes, other).find("another mesh"), std::string::npos);
}

TEST(CheckpointFile, namesTheSettingsThatHaveChanged) {
  Simulation simulation(built("grid", {{"grid.resolution", "9"}}));
  const std::string bytes = checkpointOf(simulation);
  Simulation windy(built("grid", {{"grid.resolution", "9"}, {"gravity", "5"}, {"threads", "2"}}));
  const std::vector<std::string> notes = continueFrom(bytes, windy);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("gravity is 5, and was ", 0), 0U) << notes[0];
}

/// A small sheet above a sphere, with a pin and a band.
std::string sheetText(const std::string& body, const std::string& pins, const std::string& cloth) {
  return "[[cloths]]\nname = \"sheet\"\ngrid = \"horizontal\"\nposition = [0, 1, 0]\n" + cloth +
         "[[cloths.pins]]\ncorners = [\"top_left\"]\n" + pins + "[[bodies]]\n" + body +
         "[settings]\ngrid.resolution = 9\n[ground]\nheight = 0\n";
}

std::vector<std::string> notesAbout(const std::string& before, const std::string& after) {
  Simulation simulation(testing::sceneFrom(before));
  testing::takeSteps(simulation, 2);
  Simulation changed(testing::sceneFrom(after));
  return continueFrom(checkpointOf(simulation), changed);
}

TEST(CheckpointFile, namesThePartsOfTheSceneThatHaveChanged) {
  const std::string ball = "shape = \"sphere\"\nradius = 0.15\nposition = [0, 0.5, 0]\n";
  const std::string keys = "keyframes = [{ time = 0 }, { time = 1, position = [0, 0.2, 0] }]\n";
  const std::string band = "bands = [{ nearest = [0, 0, 0], length = 0.9 }]\n";
  const std::string whole = sheetText(ball, keys, band);
  const auto replaced = [&whole](const std::string& old, const std::string& now) {
    std::string text = whole;
    return text.replace(text.find(old), old.size(), now);
  };
  EXPECT_TRUE(notesAbout(whole, whole).empty());
  EXPECT_TRUE(notesAbout(whole, "title = \"Another title\"\n" + whole).empty()) << "it does not move the cloth";
  using Notes = std::vector<std::string>;
  const Notes bodies{"the bodies of the scene changed since the checkpoint was saved"};
  EXPECT_EQ(notesAbout(whole, replaced("radius = 0.15", "radius = 0.16")), bodies);
  EXPECT_EQ(notesAbout(whole, replaced("radius = 0.15", "radius = 0.15\nspin = [0, 10, 0]")), bodies);
  EXPECT_EQ(notesAbout(whole, replaced("radius = 0.15", "radius = 0.15\nkinetic_friction = 0.1")), bodies);
  EXPECT_EQ(notesAbout(whole, replaced("time = 1", "time = 2")),
            Notes{"the motion of the pins of the scene changed since the checkpoint was saved"});
  EXPECT_EQ(notesAbout(whole, replaced("length = 0.9", "length = 0.8")),
            Notes{"the seams or elastic bands of the scene changed since the checkpoint was saved"});
  EXPECT_EQ(notesAbout(whole, replaced("length = 0.9 }]", "length = 0.9 }]\nsettings = { stiffness = 300 }")),
            Notes{"the cloth of the scene changed since the checkpoint was saved"});
}

TEST(CheckpointFile, namesAFigureThatMovesInAnotherWay) {
  const std::string figure = "shape = \"figure\"\nmotion = \"walk\"\n";
  const std::string slower = figure + "speed = 0.7\n";
  EXPECT_TRUE(notesAbout(sheetText(figure, "", ""), sheetText(figure, "", "")).empty());
  EXPECT_EQ(notesAbout(sheetText(figure, "", ""), sheetText(slower, "", "")).size(), 1U);
}

TEST(CheckpointFile, refusesAGhost) {
  Simulation simulation(built("grid", {{"grid.resolution", "9"}, {"ghost.solver", "pcg"}}));
  EXPECT_THROW((void)checkpointOf(simulation), messages::UsageError);
}

TEST(StateBytes, refusesBytesThatAreNotExactlyOneState) {
  sim::ClothState state = sim::stateAtRest({Vec3(1, 2, 3), Vec3(4, 5, 6)});
  const std::string bytes = sim::bytesOf(state);
  EXPECT_EQ(sim::stateFromBytes(bytes)->positions[1], Vec3(4, 5, 6));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(sim::stateFromBytes(bytes.substr(0, length))) << length;
  }
  EXPECT_FALSE(sim::stateFromBytes(bytes + '\0'));
  state.velocities.pop_back();
  EXPECT_FALSE(sim::stateFromBytes(sim::bytesOf(state)));
}

}  // namespace
}  // namespace drape::session
