#include "reference_step.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

using testing::largestDifference;
using testing::pinnedSheet;
using testing::referenceStep;
using testing::shaken;

std::unique_ptr<Solver> oneIteration() {
  return findSolver("one_iteration")->make();
}

/// Runs both for some steps from a shaken start and returns how far they ever part.
double differenceFromReference(const StepParameters& parameters, const StepInputs& inputs = {}) {
  const auto model = pinnedSheet(5);
  ClothState fast = shaken(*model, 0.03, 7);
  ClothState plain = fast;
  const auto solver = oneIteration();
  double largest = 0.0;
  for (int step = 0; step < 10; ++step) {
    solver->step(*model, parameters, inputs, fast);
    referenceStep(*model, parameters, inputs, plain);
    largest = std::max(largest, largestDifference(fast, plain));
  }
  return largest;
}

TEST(OneIteration, equalsTheDenseReferenceForSpringsAlone) {
  EXPECT_LT(differenceFromReference({}), 1e-10);
}

TEST(OneIteration, equalsTheDenseReferenceWithDamping) {
  StepParameters parameters;
  parameters.material.damping = 0.02;
  EXPECT_LT(differenceFromReference(parameters), 1e-10);
}

TEST(OneIteration, equalsTheDenseReferenceWithWindDragAndLift) {
  StepParameters parameters;
  parameters.air.drag = 0.8;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.2, -2.0);
  EXPECT_LT(differenceFromReference(parameters), 1e-10);
}

TEST(OneIteration, equalsTheDenseReferenceForSeveralSweepsAndEverythingTogether) {
  for (const int sweeps : {1, 3, 5, 9}) {
    StepParameters parameters;
    parameters.jacobi.sweeps = sweeps;
    parameters.material.damping = 0.01;
    parameters.material.stiffness = 1000.0;
    parameters.timeStep = 1.0 / 60.0;
    parameters.air.drag = 0.4;
    parameters.air.lift = 0.4;
    parameters.air.wind = Vec3(0.0, 0.0, 3.0);
    EXPECT_LT(differenceFromReference(parameters), 1e-10) << sweeps << " sweeps";
  }
}

TEST(OneIteration, equalsTheDenseReferenceWhileAnAttachmentPulls) {
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, 5.0}};
  EXPECT_LT(differenceFromReference({}, inputs), 1e-10);
  inputs.attachment->maxForce = 0.05;
  EXPECT_LT(differenceFromReference({}, inputs), 1e-10);
}

TEST(OneIteration, equalsTheDenseReferenceInEveryVariantOfTheForceDerivative) {
  for (const auto variant : testing::allDerivatives) {
    StepParameters parameters;
    parameters.derivative = variant;
    parameters.material.damping = 0.01;
    EXPECT_LT(differenceFromReference(parameters), 1e-9) << static_cast<int>(variant);
  }
}

TEST(OneIteration, equalsTheDenseReferenceForDampedSweepsOddAndEven) {
  for (const int sweeps : {1, 2, 3, 4}) {
    for (const double relaxation : {0.5, 0.8}) {
      StepParameters parameters;
      parameters.jacobi.sweeps = sweeps;
      parameters.jacobi.relaxation = relaxation;
      EXPECT_LT(differenceFromReference(parameters), 1e-10) << sweeps << " sweeps by " << relaxation;
    }
  }
}

TEST(OneIteration, makesAFreeVertexFallByBackwardEulersClosedForm) {
  const auto model = buildClothModel(testing::sheet(3), 0.1, MassLumping::Uniform, {});
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  const int steps = 30;
  const auto solver = oneIteration();
  for (int step = 0; step < steps; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  const double h = parameters.timeStep;
  const double expected = -0.5 * parameters.gravity * h * h * steps * (steps + 1);
  for (const Vec3& position : state.positions) {
    EXPECT_NEAR(position.y(), expected, 1e-12);
  }
}

TEST(OneIteration, leavesAClothAtRestWithoutForcesWhereItIs) {
  const auto model = pinnedSheet(9);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air.drag = 1.0;
  parameters.air.lift = 1.0;
  const auto solver = oneIteration();
  for (int step = 0; step < 100; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - model->restPositions[v]).norm(), 1e-13);
  }
}

TEST(OneIteration, keepsPinnedVerticesWhereTheyAre) {
  const auto model = pinnedSheet(9);
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = oneIteration();
  for (int step = 0; step < 200; ++step) {
    solver->step(*model, {}, {}, state);
  }
  EXPECT_EQ(state.positions[0], model->restPositions[0]);
  EXPECT_EQ(state.positions[8], model->restPositions[8]);
  EXPECT_EQ(state.velocities[0], Vec3(Vec3::Zero()));
  EXPECT_LT(state.positions[80].y(), -0.3) << "the free end should have fallen";
}

TEST(OneIteration, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = pinnedSheet(65);
  const auto run = [&](int threads) {
    ClothState state = shaken(*model, 0.002, 3);
    StepParameters parameters;
    parameters.threads = threads;
    parameters.air.drag = 0.5;
    parameters.air.lift = 0.5;
    parameters.material.damping = 0.01;
    parameters.air.wind = Vec3(2.0, 0.0, 1.0);
    const auto solver = oneIteration();
    for (int step = 0; step < 40; ++step) {
      solver->step(*model, parameters, {}, state);
    }
    return stateHash(state);
  };
  const auto hash = run(1);
  EXPECT_EQ(hash, run(2));
  EXPECT_EQ(hash, run(3));
  EXPECT_EQ(hash, run(8));
}

TEST(OneIteration, isCalmAtALargeStepWhereExplicitStepsExplode) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = oneIteration();
  double largest = -std::numeric_limits<double>::infinity();
  for (int step = 0; step < 300; ++step) {
    solver->step(*model, parameters, {}, state);
    largest = std::max(largest, energyOf(*model, parameters, state).total());
  }
  EXPECT_TRUE(isFinite(state));
  EXPECT_LT(largest, 1.0) << "[J]; the sheet starts with none, and about 0.5 J is known for this start";
}

TEST(OneIteration, neverPullsHarderThanTheAttachmentMay) {
  const auto model = buildClothModel(testing::sheet(3), 0.1, MassLumping::Uniform, {});
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.gravity = 0.0;
  StepInputs inputs;
  inputs.attachment = Attachment{{0, Vec3(1.0, 0.0, 0.0), Vec3(1e6, 0.0, 0.0)}, {1e5, 2.0}};
  oneIteration()->step(*model, parameters, inputs, state);
  double momentum = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    momentum += model->vertexMass[v] * state.velocities[v].norm();
  }
  EXPECT_LE(momentum, inputs.attachment->maxForce * parameters.timeStep * (1.0 + 1e-12));
  EXPECT_GT(momentum, 0.0);
}

TEST(OneIteration, staysFiniteInAStormThatWouldThrowLightVerticesBack) {
  const auto model = pinnedSheet(9);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.air.drag = 2.0;
  parameters.air.lift = 1.0;
  parameters.air.wind = Vec3(0.0, 0.0, 100.0);
  const auto solver = oneIteration();
  for (int step = 0; step < 300; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  EXPECT_TRUE(isFinite(state));
  for (const Vec3& velocity : state.velocities) {
    EXPECT_LT(velocity.norm(), 150.0);
  }
}

TEST(OneIteration, survivesVerticesThatFallTogether) {
  const auto model = pinnedSheet(3);
  ClothState state = stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5)));
  oneIteration()->step(*model, {}, {}, state);
  EXPECT_TRUE(isFinite(state));
}

}  // namespace
}  // namespace drape::sim
