#include "report/trajectory.hpp"

#include "messages/error.hpp"
#include "sim/stepping/stepper.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::report {
namespace {

std::string refusalOf(double timeStep) {
  try {
    (void)stepsPerCheckpoint(timeStep);
  } catch (const messages::UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Trajectory, takesWholeStepsFromCheckpointToCheckpoint) {
  EXPECT_EQ(stepsPerCheckpoint(1.0 / 150.0), 5);
  EXPECT_EQ(stepsPerCheckpoint(1.0 / 30.0), 1);
  EXPECT_EQ(stepsPerCheckpoint(1.0 / 90000.0), 3000);
  EXPECT_EQ(stepsPerCheckpoint(0.00666666667), 5);
}

TEST(Trajectory, refusesAStepThatMissesTheCheckpointsAndNamesTheNearestThatFit) {
  EXPECT_NE(refusalOf(0.01).find("0.01 s does not: use 1/90 s or 1/120 s"), std::string::npos) << refusalOf(0.01);
  EXPECT_NE(refusalOf(0.05).find("use 1/30 s"), std::string::npos) << refusalOf(0.05);
}

TEST(Trajectory, coversTheNearestWholeNumberOfCheckpoints) {
  EXPECT_EQ(checkpointsIn(0.5), 15);
  EXPECT_EQ(checkpointsIn(7.0 / 15.0), 14);
  EXPECT_THROW((void)checkpointsIn(0.01), messages::UsageError);
}

TEST(Trajectory, isTheSameRunToTheLastBitAsTheStepperTakes) {
  const auto scene = testing::smallGrid({"integration=bdf2", "wind.z=2", "drag=0.5"});
  const Trajectory trajectory = runTrajectory(*scene, scene->settings, 3);
  sim::Stepper stepper(scene->settings.solver.name);
  sim::ClothState state = scene->start;
  for (int i = 0; i < 15; ++i) {
    stepper.step(*scene->model, scene->settings.step, {}, state);
  }
  ASSERT_EQ(trajectory.checkpoints(), 3);
  EXPECT_EQ(sim::stateHash(trajectory.states[0]), sim::stateHash(scene->start));
  EXPECT_EQ(sim::stateHash(trajectory.states[3]), sim::stateHash(state));
}

TEST(Trajectory, keepsTheEnergysAccountFromTheStart) {
  const auto scene = testing::smallGrid({"damping=0.01"});
  const Trajectory trajectory = runTrajectory(*scene, scene->settings, 4, {.energy = true});
  ASSERT_EQ(trajectory.balances.size(), 5U);
  EXPECT_EQ(trajectory.balances[0].change(), 0.0);
  for (std::size_t k = 1; k < 5; ++k) {
    const double change = sim::energyOf(*scene->model, scene->settings.step, trajectory.states[k]).total() -
                          sim::energyOf(*scene->model, scene->settings.step, trajectory.states[0]).total();
    EXPECT_NEAR(trajectory.balances[k].change(), change, 1e-14);
  }
  EXPECT_LT(trajectory.balances[4].damping(), 0.0);
}

TEST(Trajectory, keepsTheLargestEnergyOfAnyStep) {
  const auto scene = testing::smallGrid();
  const Trajectory trajectory = runTrajectory(*scene, scene->settings, 3, {.energyPeak = true});
  sim::Stepper stepper(scene->settings.solver.name);
  sim::ClothState state = scene->start;
  double largest = sim::energyOf(*scene->model, scene->settings.step, state).total();
  for (int i = 0; i < 15; ++i) {
    stepper.step(*scene->model, scene->settings.step, {}, state);
    largest = std::max(largest, sim::energyOf(*scene->model, scene->settings.step, state).total());
  }
  EXPECT_EQ(trajectory.largestEnergy, largest);
}

TEST(Trajectory, reportsEachStep) {
  const auto scene = testing::smallGrid();
  std::int64_t calls = 0;
  std::int64_t last = 0;
  std::int64_t total = 0;
  Watch watch;
  watch.progress = [&](std::string_view, std::int64_t done, std::int64_t all) {
    ++calls;
    last = done;
    total = all;
  };
  (void)runTrajectory(*scene, scene->settings, 2, watch);
  EXPECT_EQ(calls, 10);
  EXPECT_EQ(last, 10);
  EXPECT_EQ(total, 10);
}

TEST(Trajectory, endsAtTheLastFiniteCheckpointWhenTheClothBlowsUp) {
  // Without the transverse part of the derivative stiff cloth is unstable.
  const auto scene = testing::smallGrid({"grid.resolution=17", "stiffness=1e7", "derivative=axial"});
  const Trajectory trajectory = runTrajectory(*scene, scene->settings, 60);
  EXPECT_FALSE(trajectory.finite);
  EXPECT_LT(trajectory.checkpoints(), 60);
  EXPECT_TRUE(sim::isFinite(trajectory.states.back()));
}

TEST(RestartedTrajectory, isTheFreeRunInTheFirstIntervalAndNotInTheSecond) {
  const auto scene = testing::smallGrid();
  const Trajectory reference = runTrajectory(*scene, testing::with(*scene, {"time_step=1/3000"}), 4);
  const Trajectory running = runTrajectory(*scene, scene->settings, 4);
  const Trajectory restarted = runRestarted(*scene, scene->settings, reference);
  ASSERT_EQ(restarted.checkpoints(), 4);
  EXPECT_EQ(sim::stateHash(restarted.states[1]), sim::stateHash(running.states[1]));
  EXPECT_NE(sim::stateHash(restarted.states[2]), sim::stateHash(running.states[2]));
}

TEST(RestartedTrajectory, ofTheReferencesOwnMethodIsTheReference) {
  const auto scene = testing::smallGrid({"integration=theta"});
  const Trajectory reference = runTrajectory(*scene, scene->settings, 4);
  const Trajectory restarted = runRestarted(*scene, scene->settings, reference);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(sim::stateHash(restarted.states[k]), sim::stateHash(reference.states[k]));
  }
}

TEST(RestartedTrajectory, keepsTheEnergysAccountOfEachIntervalAlone) {
  const auto scene = testing::smallGrid();
  const Trajectory reference = runTrajectory(*scene, testing::with(*scene, {"time_step=1/3000"}), 3);
  const Trajectory restarted = runRestarted(*scene, scene->settings, reference, {.energy = true});
  const double change = sim::energyOf(*scene->model, scene->settings.step, restarted.states[3]).total() -
                        sim::energyOf(*scene->model, scene->settings.step, reference.states[2]).total();
  EXPECT_NEAR(restarted.balances[3].change(), change, 1e-14);
}

}  // namespace
}  // namespace drape::report
