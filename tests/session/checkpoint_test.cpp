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
