#include "sim/adaptive/settling.hpp"

#include "sim/adaptive/tuning.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/measures/measures.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <utility>
#include <vector>

namespace drape::sim::adaptive {
namespace {

constexpr double timeStep = 1.0 / 64.0;  // [s], so that intervals are full numbers of steps
constexpr double tolerance = 1e-4;       // [m]
const int stepsUntilSettling = static_cast<int>(tuning.settlingIntervals * tuning.settlingInterval / timeStep) + 1;

/// A sheet that moves uniformly, with a contact.
class Settling : public ::testing::Test {
 protected:
  Settling() {
    parameters.timeStep = timeStep;
    parameters.air.drag = 1.0;
    inputs.contacts = &contacts;
  }

  /// Moves the sheet at that speed [m/s] for some steps. @return the work in the last step [J]
  double move(double speed, int steps) {
    double work = 0.0;
    for (int step = 0; step < steps; ++step) {
      state.velocities.assign(state.positions.size(), Vec3(speed, 0.0, 0.0));
      work = settle(*model, {parameters, parameters.contact, inputs, tolerance}, memory, state);
      for (Vec3& position : state.positions) {
        position.x() += timeStep * speed;
      }
      state.time += timeStep;
    }
    return work;
  }

  std::shared_ptr<const ClothModel> model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Uniform, {});
  std::vector<SubstepContact> contacts{1};
  StepParameters parameters;
  StepInputs inputs;
  StepMemory memory;
  ClothState state = stateAtRest(model->restPositions);
};

constexpr double slow = 0.9 * tolerance / 0.25;  // [m/s]

TEST_F(Settling, slowsClothInContactThatHardlyMovesAndReturnsItsLossOfEnergy) {
  const double before = 0.5 * 0.1 * slow * slow;
  const double work = move(slow, stepsUntilSettling);
  const double factor = std::exp(-timeStep / tuning.settlingTime);
  EXPECT_NEAR(state.velocities[7].x(), factor * slow, 1e-12);
  EXPECT_NEAR(work, (factor * factor - 1.0) * before, 1e-12 * before);
}

TEST_F(Settling, waitsForTwoIntervals) {
  EXPECT_EQ(move(slow, stepsUntilSettling - 2), 0.0);
}

TEST_F(Settling, leavesFasterClothAlone) {
  EXPECT_EQ(move(1.2 * slow, 10 * stepsUntilSettling), 0.0);
}

TEST_F(Settling, leavesClothAloneOfWhichOneVertexMoves) {
  for (int step = 0; step < 10 * stepsUntilSettling; ++step) {
    state.positions[3].y() += 1.1 * tuning.maxSettlingRatio * tolerance * timeStep / tuning.settlingInterval;
    EXPECT_EQ(move(0.0, 1), 0.0);
  }
}

TEST_F(Settling, endsAsSoonAsTheClothMoves) {
  ASSERT_LT(move(slow, stepsUntilSettling), 0.0);
  const double fast = 2.0 * tolerance / timeStep;
  move(fast, 1);
  EXPECT_EQ(move(fast, 1), 0.0);
  EXPECT_EQ(move(slow, stepsUntilSettling - 2), 0.0) << "the intervals begin again";
}

TEST_F(Settling, isOnlyForClothThatCouldSleep) {
  inputs.contacts = nullptr;
  EXPECT_EQ(move(slow, 2 * stepsUntilSettling), 0.0) << "without contact";
  inputs.contacts = &contacts;
  inputs.attachment = Attachment{};
  EXPECT_EQ(move(slow, 2 * stepsUntilSettling), 0.0) << "held by the mouse";
  inputs.attachment.reset();
  std::vector<contact::BodyStep> bodies(1);
  bodies.front().end.position.x() = 1e-6;
  inputs.bodies = &bodies;
  EXPECT_EQ(move(slow, 2 * stepsUntilSettling), 0.0) << "a body moves";
  inputs.bodies = nullptr;
  parameters.air.drag = 0.0;
  EXPECT_EQ(move(slow, 2 * stepsUntilSettling), 0.0) << "undamped";
}

/// A sheet over the edge of a box, with little damping, whose free part swings.
class SwingingOverAnEdge : public ::testing::Test {
 protected:
  SwingingOverAnEdge() {
    box.shape = contact::BoxShape{.half = Vec3(0.5, 0.5, 1.0)};
    bodies.assign(1, contact::BodyStep{});
    bodies.front().body = &box;
    bodies.front().start.position = bodies.front().end.position = Vec3(0.0, -0.51, 0.0);
    inputs.bodies = &bodies;
    parameters.material.stiffness = 200.0;
    parameters.material.damping = 1e-3;
    parameters.air.drag = 0.05;
    parameters.contact.self = contact::SelfCollision::Off;
    ClothMesh mesh = testing::sheet(9);
    for (Vec3& position : mesh.positions) {
      position = Vec3(position.x() - 0.1, 0.0, position.y() - 0.5);
    }
    model = buildClothModel(mesh, 0.1, MassLumping::Uniform, {});
    state = stateAtRest(model->restPositions);
  }

  /// Takes steps until the cloth sleeps. @return whether it does before that time [s]
  bool fallsAsleep(double seconds) {
    while (state.time < seconds) {
      if (stepper.step(*model, parameters, inputs, state).choice.value().sleeping) {
        return true;
      }
    }
    return false;
  }

  contact::Body box;
  std::vector<contact::BodyStep> bodies;
  std::shared_ptr<const ClothModel> model;
  StepParameters parameters;
  StepInputs inputs;
  ClothState state;
  Stepper stepper{"auto"};
};

TEST_F(SwingingOverAnEdge, fallsAsleepEarlierThanWithATighterTolerance) {
  ASSERT_TRUE(fallsAsleep(60.0));
  const double asleepAt = state.time;
  parameters.automatic.errorTolerance = 1e-7;
  state = stateAtRest(model->restPositions);
  EXPECT_FALSE(fallsAsleep(asleepAt));
}

TEST_F(SwingingOverAnEdge, movesLessThanTheToleranceAwayFromTheMotionWithoutSettling) {
  while (stepMemoryOf(state).slowIntervals < tuning.settlingIntervals && state.time < 60.0) {
    stepper.step(*model, parameters, inputs, state);
  }
  ASSERT_LT(state.time, 60.0);
  ClothState free = state;
  const double end = state.time + 0.2;
  while (state.time < end) {
    stepper.step(*model, parameters, inputs, state);
    StepMemory memory = stepMemoryOf(free);
    memory.slowIntervals = 0;
    storeStepMemory(std::move(memory), free);
    stepper.step(*model, parameters, inputs, free);
  }
  EXPECT_GT(meanDistance(state.positions, free.positions), 0.0);
  EXPECT_LT(meanDistance(state.positions, free.positions), parameters.automatic.errorTolerance);
}

}  // namespace
}  // namespace drape::sim::adaptive
