#include "session/accuracy_check.hpp"

#include "session/simulation.hpp"
#include "sim/measures/measures.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace drape::session {
namespace {

using testing::smallGrid;

constexpr int stepsOfACheck = 30;  // of 1/150 s

void change(Simulation& simulation, const char* key, const settings::SettingValue& value) {
  simulation.apply(SetSettingCommand{key, value});
  ASSERT_EQ(simulation.message(), "");
}

/// Waits for a check in the background.
std::optional<sim::Accuracy> awaited(const Simulation& simulation) {
  for (int i = 0; i < 2000 && !simulation.accuracy(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return simulation.accuracy();
}

TEST(AccuracyCheck, doesNotChangeABitOfTheCloth) {
  Simulation alone(smallGrid());
  Simulation checked(smallGrid());
  change(checked, "error_check", true);
  testing::takeSteps(alone, stepsOfACheck + 5);
  testing::takeSteps(checked, stepsOfACheck + 5);
  EXPECT_TRUE(checked.accuracy());
  EXPECT_EQ(sim::stateHash(alone.state()), sim::stateHash(checked.state()));
}

/// Expects the error of the check within a factor of five of the distance from a much more accurate run.
void expectRight(const Simulation& checked, const Simulation& fine, const std::string& what) {
  const double error = sim::meanDistance(checked.state().positions, fine.state().positions);
  ASSERT_TRUE(checked.accuracy()) << what;
  EXPECT_TRUE(sim::isErrorKnown(*checked.accuracy())) << what;
  EXPECT_LT(checked.accuracy()->error, 5.0 * error) << what;
  EXPECT_GT(checked.accuracy()->error, error / 5.0) << what;
  EXPECT_NEAR(checked.accuracy()->seconds, AccuracyCheck::window, 1e-9);
}

/// Verlet far below its stability limit.
void makeFine(Simulation& simulation) {
  change(simulation, "solver", std::string("verlet"));
  change(simulation, "substeps", 500);
}

TEST(AccuracyCheck, findsTheErrorOfAMethodWithinAFactorOfFive) {
  for (const char* solver : {"one_iteration", "newton", "auto"}) {
    Simulation checked(smallGrid());
    change(checked, "solver", std::string(solver));
    change(checked, "error_check", true);
    testing::takeSteps(checked, stepsOfACheck);
    Simulation fine(smallGrid());
    makeFine(fine);
    testing::takeSteps(fine, stepsOfACheck);
    expectRight(checked, fine, solver);
  }
}

TEST(AccuracyCheck, countsTheErrorThatHandsAndChangedSettingsCause) {
  const auto use = [](Simulation& simulation) {
    testing::takeSteps(simulation, 5);
    simulation.apply(AttachCommand{{70, Vec3::Constant(1.0 / 3.0), Vec3(0.1, 1.2, 0.3)}});
    testing::takeSteps(simulation, 10);
    change(simulation, "stiffness", 20.0);
    change(simulation, "wind.z", 4.0);
    simulation.apply(TogglePinCommand{});
    testing::takeSteps(simulation, stepsOfACheck - 15);
  };
  Simulation checked(smallGrid());
  change(checked, "solver", std::string("auto"));
  change(checked, "error_check", true);
  use(checked);
  Simulation fine(smallGrid());
  makeFine(fine);
  use(fine);
  expectRight(checked, fine, "auto");
}

/// Verlet takes the lift of eq. 20, which the settings ask for, and `auto` at most that of a thin plate.
TEST(AccuracyCheck, countsTheLiftThatAutoDoesNotTake) {
  const auto blow = [](Simulation& simulation) {
    change(simulation, "drag", 0.5);
    change(simulation, "lift", 0.3);
    change(simulation, "wind.x", 8.0);
  };
  Simulation checked(smallGrid());
  change(checked, "solver", std::string("auto"));
  change(checked, "error_check", true);
  blow(checked);
  testing::takeSteps(checked, stepsOfACheck);
  Simulation fine(smallGrid());
  makeFine(fine);
  blow(fine);
  testing::takeSteps(fine, stepsOfACheck);
  EXPECT_GT(sim::meanDistance(checked.state().positions, fine.state().positions), 1e-3);
  expectRight(checked, fine, "auto");
}

/// The damping of a fabric acts once in a step, so its error does not shrink with the substeps of `auto`.
/// `auto` lowers the stiffness of springs and the stretch stiffness of a fabric to keep to its cost budget.
TEST(AccuracyCheck, countsTheErrorOfALowerStiffness) {
  const std::vector<std::vector<std::string>> cloths{
      {"stiffness=1e5", "auto.soften=on", "auto.cost=1"},
      {"material.model=fabric", "material.preset=cotton", "auto.strain=0.01", "auto.cost=1", "damping=0"}};
  for (const std::vector<std::string>& settings : cloths) {
    Simulation checked(smallGrid(9, settings));
    change(checked, "solver", std::string("auto"));
    change(checked, "error_check", true);
    testing::takeSteps(checked, stepsOfACheck);
    Simulation fine(smallGrid(9, settings));
    makeFine(fine);
    testing::takeSteps(fine, stepsOfACheck);
    EXPECT_GT(sim::meanDistance(checked.state().positions, fine.state().positions), 1e-3) << settings.front();
    expectRight(checked, fine, settings.front());
  }
}

/// A sheet that falls onto a ball, which it touches after 0.03 s, and slides down there.
TEST(AccuracyCheck, countsTheErrorOfContact) {
  for (const char* solver : {"auto", "one_iteration", "xpbd"}) {
    const std::vector<std::string> settings{"grid.resolution=9", "self_collision=exact", "time_step=1/150",
                                            "substeps=4"};
    Simulation checked(testing::builtIn("sphere", settings));
    change(checked, "solver", std::string(solver));
    change(checked, "error_check", true);
    testing::takeSteps(checked, stepsOfACheck);
    constexpr int parts = 32;  // contact acts once in a step, so shorter steps make it more accurate
    Simulation fine(testing::builtIn("sphere", settings));
    change(fine, "solver", std::string("verlet"));
    change(fine, "time_step", 1.0 / 150.0 / parts);
    change(fine, "substeps", 20);
    testing::takeSteps(fine, parts * stepsOfACheck);
    EXPECT_GT(checked.lastStepReport().contact.bodyContacts, 0) << "it lies on the ball";
    expectRight(checked, fine, solver);
  }
}

TEST(AccuracyCheck, countsTheErrorOfTheDampingOfAFabric) {
  const auto grid = smallGrid(9, {"material.model=fabric", "material.preset=jersey"});
  Simulation checked(grid);
  change(checked, "solver", std::string("auto"));
  change(checked, "error_check", true);
  testing::takeSteps(checked, stepsOfACheck);
  constexpr int refinement = 40;
  Simulation fine(grid);
  change(fine, "solver", std::string("verlet"));
  change(fine, "substeps", 20);
  change(fine, "time_step", 1.0 / 150.0 / refinement);
  testing::takeSteps(fine, stepsOfACheck * refinement);
  expectRight(checked, fine, "auto");
  EXPECT_GT(checked.accuracy()->error, 0.8 * sim::meanDistance(checked.state().positions, fine.state().positions));
}

TEST(AccuracyCheck, findsTheSameInTheBackground) {
  Simulation inside(smallGrid());
  change(inside, "error_check", true);
  testing::takeSteps(inside, stepsOfACheck);
  Simulation background(smallGrid());
  background.setAccuracyInBackground(true);
  change(background, "error_check", true);
  testing::takeSteps(background, stepsOfACheck);
  ASSERT_TRUE(inside.accuracy());
  ASSERT_TRUE(awaited(background));
  EXPECT_EQ(background.accuracy()->error, inside.accuracy()->error);
  EXPECT_EQ(background.accuracy()->spread, inside.accuracy()->spread);
}

TEST(AccuracyCheck, endsWithoutAResultWhenTheStateIsReplaced) {
  Simulation simulation(smallGrid());
  change(simulation, "error_check", true);
  testing::takeSteps(simulation, stepsOfACheck - 1);
  simulation.apply(ResetCommand{});
  testing::takeSteps(simulation, 1);
  EXPECT_FALSE(simulation.accuracy());
  testing::takeSteps(simulation, stepsOfACheck - 1);
  ASSERT_TRUE(simulation.accuracy()) << "a new check began after the reset";
  EXPECT_NEAR(simulation.accuracy()->time, AccuracyCheck::window, 1e-9);
  simulation.apply(ResetCommand{});
  testing::takeSteps(simulation, 1);
  EXPECT_FALSE(simulation.accuracy()) << "the result was about the motion before";
}

TEST(AccuracyCheck, beginsAgainAfterItsIntervalAndKeepsTheLastResultUntilThen) {
  Simulation simulation(smallGrid());
  change(simulation, "error_check", true);
  const int stepsOfInterval = 750;
  testing::takeSteps(simulation, stepsOfInterval + stepsOfACheck - 1);
  ASSERT_TRUE(simulation.accuracy());
  EXPECT_NEAR(simulation.accuracy()->time, AccuracyCheck::window, 1e-9);
  testing::takeSteps(simulation, 2);
  EXPECT_NEAR(simulation.accuracy()->time, AccuracyCheck::interval + AccuracyCheck::window, 0.02);
}

}  // namespace
}  // namespace drape::session
