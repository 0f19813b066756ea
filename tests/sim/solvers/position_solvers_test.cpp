#include "dense_backward_euler.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/solvers/solver.hpp"
#include "spring_chain.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <optional>

/// XPBD and vertex block descent.
namespace drape::sim {
namespace {

using testing::denseBackwardEulerStep;
using testing::hangingChain;
using testing::pinnedSheet;
using testing::shaken;

double largestDistance(const ClothState& a, const ClothState& b) {
  double largest = 0.0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    largest = std::max(largest, (a.positions[v] - b.positions[v]).norm());
  }
  return largest;
}

/// How far a solver's step ends from the exact backward-Euler step, both from the same shaken 5 x 5 sheet [m].
double distanceFromBackwardEuler(std::string_view solver, const StepParameters& parameters,
                                 const StepInputs& inputs = {}) {
  const auto model = pinnedSheet(5);
  ClothState state = shaken(*model, 0.01, 7);
  ClothState exact = state;
  findSolver(solver)->make()->step(*model, parameters, inputs, state);
  denseBackwardEulerStep(*model, parameters, inputs, exact);
  return largestDistance(state, exact);
}

StepInputs pullingAttachment() {
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.3, 0.5)}, {20.0, 1000.0}};
  return inputs;
}

TEST(Vbd, convergesToTheBackwardEulerStepWithDampingAndAttachment) {
  StepParameters parameters;
  parameters.iteration.iterations = 2000;
  parameters.material.damping = 0.05;
  for (const double stiffness : {10.0, 100.0, 1000.0}) {
    parameters.material.stiffness = stiffness;
    EXPECT_LT(distanceFromBackwardEuler("vbd", parameters, pullingAttachment()), 1e-12) << stiffness << " N/m";
  }
}

TEST(Vbd, convergesToTheSameStepWithEveryDerivative) {
  StepParameters parameters;
  parameters.iteration.iterations = 4000;
  for (const auto derivative : {ForceDerivative::Exact, ForceDerivative::Scalar}) {
    parameters.derivative = derivative;
    EXPECT_LT(distanceFromBackwardEuler("vbd", parameters), 1e-12);
  }
}

TEST(Vbd, comesNearerWithEveryDoublingOfItsSweeps) {
  StepParameters parameters;
  parameters.iteration.spectralRadius = 0.0;
  parameters.material.stiffness = 1000.0;
  double last = 1.0;
  for (const int iterations : {10, 20, 40, 80}) {
    parameters.iteration.iterations = iterations;
    const double distance = distanceFromBackwardEuler("vbd", parameters);
    EXPECT_LT(distance, 0.8 * last);
    last = distance;
  }
}

TEST(Vbd, comesNearerWithTheDefaultAcceleration) {
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  const double accelerated = distanceFromBackwardEuler("vbd", parameters);
  parameters.iteration.spectralRadius = 0.0;
  EXPECT_LT(accelerated, 0.8 * distanceFromBackwardEuler("vbd", parameters));
}

bool overshoots(const std::optional<SolverWarning>& warning) {
  return warning && warning->kind == SolverWarning::Kind::SpectralRadius;
}

TEST(Vbd, warnsOfAnAccelerationThatOvershootsWhichReallyBlowsUp) {
  const auto model = pinnedSheet(17);
  const SolverInfo& info = *findSolver("vbd");
  const auto largestSpeed = [&](const StepParameters& parameters) {
    ClothState state = stateAtRest(model->restPositions);
    const auto solver = info.make();
    double largest = 0.0;
    for (int step = 0; step < 150; ++step) {
      solver->step(*model, parameters, {}, state);
      for (const Vec3& velocity : state.velocities) {
        largest = std::max(largest, velocity.norm());
      }
    }
    return largest;
  };
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  parameters.iteration.iterations = 3;
  parameters.iteration.spectralRadius = 0.95;
  EXPECT_GT(largestSpeed(parameters), 1e6);
  const SolverWarning warning = info.warning(*model, parameters).value();
  EXPECT_EQ(warning.kind, SolverWarning::Kind::SpectralRadius);
  EXPECT_EQ(warning.iterations, 3);
  EXPECT_EQ(warning.spectralRadius, 0.95);
  EXPECT_EQ(warning.neededIterations, 6);
  parameters.iteration.spectralRadius = 0.84;  // T_3(1 / rho) = 3.2
  EXPECT_LT(largestSpeed(parameters), 30.0);
  EXPECT_FALSE(overshoots(info.warning(*model, parameters)));
}

TEST(Vbd, warnsOfItsDefaultAccelerationWithTwoSweepsAlone) {
  const auto model = pinnedSheet(5);
  StepParameters parameters;
  parameters.material.stiffness = 1.0;
  for (int iterations = 1; iterations < 20; ++iterations) {
    parameters.iteration.iterations = iterations;
    EXPECT_EQ(overshoots(findSolver("vbd")->warning(*model, parameters)), iterations == 2);
  }
}

TEST(Xpbd, convergesToTheBackwardEulerStepWhereSpringsDoNotTurn) {
  const auto model = hangingChain(4, 0.02, 0.1);
  StepParameters parameters;
  parameters.iteration.iterations = 2000;
  ClothState state = stateAtRest(model->restPositions);
  ClothState exact = state;
  const auto solver = findSolver("xpbd")->make();
  for (int step = 0; step < 20; ++step) {
    solver->step(*model, parameters, {}, state);
    denseBackwardEulerStep(*model, parameters, {}, exact);
  }
  EXPECT_LT(largestDistance(state, exact), 1e-12);
  EXPECT_GT(std::abs(state.positions[4].y() - model->restPositions[4].y()), 1e-3);
}

TEST(Xpbd, differsFromTheBackwardEulerStepByAThirdPowerOfTheStepWhereSpringsTurn) {
  StepParameters parameters;
  parameters.iteration.iterations = 3000;
  parameters.material.stiffness = 20.0;
  parameters.timeStep = 1.0 / 400.0;
  const double coarse = distanceFromBackwardEuler("xpbd", parameters, pullingAttachment());
  parameters.timeStep /= 2.0;
  const double fine = distanceFromBackwardEuler("xpbd", parameters, pullingAttachment());
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log2(coarse / fine), 2.7) << coarse << " " << fine;
}

TEST(Xpbd, dampsEvenVeryStronglyWithoutLosingMomentum) {
  const auto model = buildClothModel(testing::sheet(5), 0.001, MassLumping::Area, {});
  ClothState state = shaken(*model, 0.02, 5);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 0.0;
  parameters.material.damping = 100.0;
  const auto kineticAndMomentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
      sum += model->vertexMass[v] * state.velocities[v];
    }
    return std::pair(energyOf(*model, parameters, state).kinetic, sum);
  };
  auto [energy, momentum] = kineticAndMomentum();
  const auto solver = findSolver("xpbd")->make();
  for (int step = 0; step < 200; ++step) {
    solver->step(*model, parameters, {}, state);
    const auto [newEnergy, newMomentum] = kineticAndMomentum();
    EXPECT_LE(newEnergy, energy * (1.0 + 1e-12));
    EXPECT_LT((newMomentum - momentum).norm(), 1e-12 * momentum.norm());
    energy = newEnergy;
  }
  const double rigid = 0.5 * momentum.squaredNorm() / model->totalMass();
  EXPECT_NEAR(energy, rigid, 1e-6 * rigid) << "the sheet should move as one";
}

class PositionSolver : public ::testing::TestWithParam<const char*> {};

TEST_P(PositionSolver, holdsALightMeshByAStiffAttachmentAtALargeStep) {
  const auto model = buildClothModel(testing::sheet(9), 0.01, MassLumping::Uniform, {0, 8});
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  StepInputs inputs;
  inputs.attachment = Attachment{{100, Vec3(0.2, 0.3, 0.5), Vec3(0.6, 0.4, 0.8)}, {500.0, 20.0}};
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = findSolver(GetParam())->make();
  for (int step = 0; step < 300; ++step) {
    solver->step(*model, parameters, inputs, state);
    for (const Vec3& position : state.positions) {
      ASSERT_LT(position.norm(), 5.0);
    }
  }
  Vec3 attached = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    attached +=
        inputs.attachment->barycentric[static_cast<Eigen::Index>(c)] * state.positions[model->triangles[100][c]];
  }
  EXPECT_LT((attached - inputs.attachment->target).norm(), 0.02);
  for (const Vec3& velocity : state.velocities) {
    EXPECT_LT(velocity.norm(), 1.0) << "the motion that the attachment caused should have decayed";
  }
}

TEST_P(PositionSolver, neverPullsHarderThanTheAttachmentMay) {
  const auto model = buildClothModel(testing::sheet(3), 0.1, MassLumping::Uniform, {});
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.iteration.iterations = 50;
  StepInputs inputs;
  inputs.attachment = Attachment{{0, Vec3(0.4, 0.3, 0.3), Vec3(1e6, 0.0, 0.0)}, {1e5, 2.0}};
  findSolver(GetParam())->make()->step(*model, parameters, inputs, state);
  Vec3 momentum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    momentum += model->vertexMass[v] * state.velocities[v];
  }
  EXPECT_NEAR(momentum.norm(), inputs.attachment->maxForce * parameters.timeStep, 1e-6);
}

TEST_P(PositionSolver, staysBoundedWhereStepsAreHugeAndStiffnessToo) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.timeStep = 0.1;
  parameters.material.stiffness = 1e7;
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = findSolver(GetParam())->make();
  for (int step = 0; step < 50; ++step) {
    solver->step(*model, parameters, {}, state);
    for (const Vec3& velocity : state.velocities) {
      ASSERT_LT(velocity.norm(), 50.0);
    }
  }
}

TEST_P(PositionSolver, saysThatClothIsTooSoftWhereItIs) {
  const auto model = pinnedSheet(17);
  const SolverInfo& info = *findSolver(GetParam());
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  const SolverWarning warning = info.warning(*model, parameters).value();
  EXPECT_EQ(warning.kind, SolverWarning::Kind::TooFewIterations);
  parameters.substeps = static_cast<int>(warning.substeps);
  EXPECT_GT(parameters.substeps, 1);
  EXPECT_FALSE(info.warning(*model, parameters));
  --parameters.substeps;
  EXPECT_TRUE(info.warning(*model, parameters));
}

INSTANTIATE_TEST_SUITE_P(Every, PositionSolver, ::testing::Values("xpbd", "vbd"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace drape::sim
