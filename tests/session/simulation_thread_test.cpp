#include "session/simulation_thread.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <functional>
#include <thread>

namespace drape::session {
namespace {

using testing::smallGrid;

/// Waits until a snapshot has a property; false after a long time.
bool eventually(SimulationThread& simulation, const std::function<bool(const Snapshot&)>& wanted) {
  for (int i = 0; i < 4000; ++i) {
    if (wanted(simulation.latest())) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(SimulationThread, hasASnapshotFromTheStart) {
  SimulationThread simulation(smallGrid(), true);
  const Snapshot& snapshot = simulation.latest();
  ASSERT_NE(snapshot.scene, nullptr);
  EXPECT_EQ(snapshot.positions.size(), 81U);
  EXPECT_TRUE(snapshot.paused);
}

TEST(SimulationThread, movesOnByItselfUnlessPaused) {
  SimulationThread simulation(smallGrid(), false);
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.step >= 10; }));
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.realTimeFactor > 0.0; }));
}

TEST(SimulationThread, standsStillWhilePausedAndTakesSingleSteps) {
  SimulationThread simulation(smallGrid(), true);
  simulation.post(SingleStepCommand{});
  simulation.post(SingleStepCommand{});
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.step == 2; }));
  // The thread has passed its loop several times when it has taken these commands one after the other.
  for (const double stiffness : {50.0, 60.0, 70.0}) {
    simulation.post(SetSettingCommand{"stiffness", stiffness});
    EXPECT_TRUE(
        eventually(simulation, [&](const Snapshot& s) { return s.settings.step.material.stiffness == stiffness; }));
  }
  EXPECT_EQ(simulation.latest().step, 2);
}

TEST(SimulationThread, changesSettingsWhileItRuns) {
  SimulationThread simulation(smallGrid(), false);
  simulation.post(SetSettingCommand{"stiffness", 77.0});
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.settings.step.material.stiffness == 77.0; }));
  simulation.post(SetSettingCommand{"stiffness", -1.0});
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return !s.message.empty(); }));
  EXPECT_EQ(simulation.latest().settings.step.material.stiffness, 77.0);
}

TEST(SimulationThread, takesCommandsAndScenesFromOtherThreadsWhileAReaderLooks) {
  SimulationThread simulation(smallGrid(), false);
  std::thread commander([&simulation] {
    for (int i = 0; i < 200; ++i) {
      simulation.post(AttachCommand{{i % 50, Vec3::Constant(1.0 / 3.0), Vec3(0.0, 1.5, 0.0)}});
      simulation.post(SetSettingCommand{"wind.x", 0.01 * i});
      if (i % 50 == 0) {
        simulation.post(LoadSceneCommand{smallGrid(9 + i / 50)});
      }
    }
    simulation.post(DetachCommand{});
  });
  for (int i = 0; i < 500; ++i) {
    const Snapshot& snapshot = simulation.latest();
    ASSERT_EQ(snapshot.positions.size(), snapshot.model->restPositions.size());
  }
  commander.join();
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.positions.size() == 144U && !s.attachment; }));
}

TEST(SimulationThread, replacesScenesAndTheirBodiesWhileItsErrorIsChecked) {
  const auto sceneWithBody = [] { return testing::builtIn("sphere", {"grid.resolution=5"}); };
  SimulationThread simulation(sceneWithBody(), false);
  for (int i = 0; i < 10; ++i) {
    simulation.post(SetSettingCommand{"error_check", true});
    ASSERT_TRUE(
        eventually(simulation, [](const Snapshot& s) { return s.settings.measures.errorCheck && s.step >= 3; }));
    simulation.post(LoadSceneCommand{sceneWithBody()});
  }
  simulation.post(SetSettingCommand{"error_check", true});
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.accuracy.has_value(); }));
}

TEST(SimulationThread, slowsTheClockDownInsteadOfFallingBehind) {
  scene::SceneDescription description = scene::openScene("grid");
  description.settings.grid.resolution = 129;
  description.settings.step.timeStep = 1e-5;
  SimulationThread simulation(scene::buildScene(description, description.settings), false);
  EXPECT_TRUE(eventually(simulation, [](const Snapshot& s) { return s.realTimeFactor > 0.0; }));
  EXPECT_LT(simulation.latest().realTimeFactor, 0.5);
}

}  // namespace
}  // namespace drape::session
