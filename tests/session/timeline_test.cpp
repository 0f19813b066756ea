#include "session/timeline.hpp"

#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace drape::session {
namespace {

RecordedState stateAt(std::int64_t step, double timeStep, int vertices = 100) {
  RecordedState state;
  state.step = step;
  state.state = sim::stateAtRest(std::vector<Vec3>(static_cast<std::size_t>(vertices), Vec3::Zero()));
  state.state.time = static_cast<double>(step) * timeStep;
  return state;
}

/// Records due states up to a step.
void record(Timeline& timeline, std::int64_t from, std::int64_t to, double timeStep, int vertices = 100) {
  for (std::int64_t step = from; step <= to; ++step) {
    if (timeline.isDue(step, timeStep)) {
      timeline.record(stateAt(step, timeStep, vertices));
    }
  }
}

TEST(Timeline, RecordsNothingWithoutMemory) {
  Timeline timeline;
  record(timeline, 0, 100, 0.01);
  EXPECT_EQ(timeline.at(50), nullptr);
  EXPECT_FALSE(timeline.status(0.01));
}

TEST(Timeline, KeepsAStateAFrameForAMinute) {
  constexpr double timeStep = 1.0 / 240.0;
  Timeline timeline;
  timeline.limit(1000.0);
  record(timeline, 0, 240 * 100, timeStep, 1);
  const TimelineStatus status = timeline.status(timeStep).value();
  EXPECT_EQ(status.spacing, 4);
  EXPECT_EQ(status.states, 60U * 60U + 1U);
  EXPECT_NEAR(status.begin, 40.0, 1e-9);
  EXPECT_NEAR(status.end, 100.0, 1e-9);
  EXPECT_EQ(timeline.at(240 * 50 + 3)->step, 240 * 50);
}

TEST(Timeline, StaysWithinItsMemoryAndCoversTheWholeMinuteThen) {
  constexpr double timeStep = 1.0 / 60.0;
  Timeline timeline;
  timeline.limit(1.0);
  for (int step = 0; step < 60 * 90; ++step) {
    if (timeline.isDue(step, timeStep)) {
      timeline.record(stateAt(step, timeStep, 500));
      ASSERT_LE(timeline.status(timeStep)->megabytes, 1.0);
    }
  }
  const TimelineStatus status = timeline.status(timeStep).value();
  EXPECT_GT(status.spacing, 1);
  EXPECT_GT(status.megabytes, 0.3);
  EXPECT_NEAR(status.end - status.begin, 60.0, 3.0);
}

TEST(Timeline, ReplacesTheFutureOfAnEarlierState) {
  Timeline timeline;
  timeline.limit(100.0);
  record(timeline, 0, 50, 1.0 / 60.0);
  timeline.record(stateAt(20, 1.0 / 60.0));
  EXPECT_EQ(timeline.at(1000)->step, 20);
  EXPECT_EQ(timeline.at(19)->step, 19);
}

TEST(Timeline, FindsTheStateNearestToATime) {
  Timeline timeline;
  timeline.limit(100.0);
  record(timeline, 0, 60, 1.0 / 60.0);
  EXPECT_EQ(timeline.nearest(0.502).step, 30);
  EXPECT_EQ(timeline.nearest(-5.0).step, 0);
  EXPECT_EQ(timeline.nearest(99.0).step, 60);
}

TEST(SimulationTimeline, ComesBackToTheLastStateAfterALookAtEarlierOnes) {
  Simulation simulation(testing::smallGrid(9, {"timeline.memory=100", "time_step=0.004"}));
  for (int i = 0; i < 50; ++i) {
    simulation.step();
  }
  const std::uint64_t last = sim::stateHash(simulation.state());
  simulation.apply(GoToCommand{0.05});
  EXPECT_NE(sim::stateHash(simulation.state()), last);
  simulation.apply(GoToCommand{100.0});
  EXPECT_EQ(sim::stateHash(simulation.state()), last);
  EXPECT_EQ(simulation.stepIndex(), 50);
}

TEST(SimulationTimeline, GoesBackStateByStateToTheStart) {
  Simulation simulation(testing::smallGrid(9, {"timeline.memory=100"}));
  for (int i = 0; i < 12; ++i) {
    simulation.step();
  }
  std::int64_t before = simulation.stepIndex();
  while (before > 0) {
    simulation.apply(StepBackCommand{});
    ASSERT_LT(simulation.stepIndex(), before);
    before = simulation.stepIndex();
  }
  EXPECT_EQ(simulation.message(), "");
  simulation.apply(StepBackCommand{});
  EXPECT_NE(simulation.message(), "") << "there is nothing before the start";
  EXPECT_EQ(simulation.stepIndex(), 0);
}

TEST(SimulationTimeline, AlsoMovesTheGhostBack) {
  Simulation simulation(testing::smallGrid(9, {"timeline.memory=100", "ghost.solver=newton"}));
  std::vector<std::uint64_t> ghosts;
  for (int i = 0; i < 40; ++i) {
    simulation.step();
    ghosts.push_back(sim::stateHash(simulation.ghost()->state()));
  }
  simulation.apply(GoToCommand{0.1});
  const auto from = static_cast<std::size_t>(simulation.stepIndex());
  ASSERT_GT(from, 0U);
  EXPECT_EQ(sim::stateHash(simulation.ghost()->state()), ghosts[from - 1]);
  for (std::size_t i = from; i < ghosts.size(); ++i) {
    simulation.step();
    ASSERT_EQ(sim::stateHash(simulation.ghost()->state()), ghosts[i]);
  }
}

TEST(SimulationTimeline, AlsoMovesADraggedBodyBack) {
  Simulation simulation(testing::builtIn("sphere", {"timeline.memory=500"}));
  simulation.apply(MoveBodyCommand{0, Vec3(0.0, 0.3, 0.0)});
  for (int i = 0; i < 60; ++i) {
    simulation.step();
  }
  const double time = simulation.state().time;
  const Vec3 place = simulation.bodies().pose(0).position;
  const std::uint64_t hash = sim::stateHash(simulation.state());
  simulation.apply(GoToCommand{0.02});
  EXPECT_LT(simulation.bodies().shift(0).y(), 0.3);
  while (simulation.state().time < time - 1e-9) {
    simulation.step();
  }
  EXPECT_EQ(simulation.bodies().pose(0).position, place);
  EXPECT_EQ(sim::stateHash(simulation.state()), hash);
}

TEST(SimulationTimeline, OfASessionCanBeReplayed) {
  const auto scene = testing::smallGrid(9, {"timeline.memory=100"});
  Simulation simulation(scene);
  const auto take = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation.step();
    }
  };
  take(30);
  simulation.apply(GoToCommand{0.06});
  simulation.apply(SetSettingCommand{"gravity", 3.0});
  take(20);
  simulation.apply(StepBackCommand{});
  take(5);
  Simulation again(scene);
  again.replay(simulation.log(), simulation.stepsTaken());
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(simulation.state()));
}

TEST(SimulationTimeline, SaysThatNothingIsRecorded) {
  Simulation simulation(testing::smallGrid());
  simulation.step();
  simulation.apply(GoToCommand{0.0});
  EXPECT_NE(simulation.message().english().find("timeline.memory"), std::string::npos);
  EXPECT_EQ(simulation.stepIndex(), 1);
}

TEST(SimulationTimeline, StartsAnewWithAnotherScene) {
  Simulation simulation(testing::smallGrid(9, {"timeline.memory=100"}));
  for (int i = 0; i < 20; ++i) {
    simulation.step();
  }
  simulation.apply(LoadSceneCommand{testing::smallGrid(5, {"timeline.memory=100"})});
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_FALSE(snapshot.timeline);
  simulation.step();
  simulation.apply(GoToCommand{0.0});
  EXPECT_EQ(simulation.state().positions.size(), 25U);
}

}  // namespace
}  // namespace drape::session
