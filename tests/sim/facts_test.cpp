#include "all_forces.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

/// What is known about the one-iteration method and those around it, as figures. The scene is that of the paper: a flat
/// sheet of 1 m and 0.1 kg, pinned at two corners, falling from rest, without damping and air.
namespace drape::sim {
namespace {

using testing::pinnedSheet;

StepParameters with(double stiffness, double timeStep) {
  StepParameters parameters;
  parameters.material.stiffness = stiffness;
  parameters.timeStep = timeStep;
  return parameters;
}

/// The largest total energy within 2 s [J]; the sheet starts with none.
double largestEnergy(const char* solver, int n, const StepParameters& parameters) {
  const auto model = pinnedSheet(n);
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper(solver);
  double largest = 0.0;
  for (int step = 0; step * parameters.timeStep < 2.0; ++step) {
    stepper.step(*model, parameters, {}, state);
    const double energy = energyOf(*model, parameters, state).total();
    if (!std::isfinite(energy)) {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max(largest, energy);
  }
  return largest;
}

TEST(OddSweeps, areCalmAndEvenOnesRattle) {
  StepParameters parameters = with(1e3, 1.0 / 150.0);
  for (const int sweeps : {1, 3, 5}) {
    parameters.jacobi.sweeps = sweeps;
    EXPECT_LT(largestEnergy("one_iteration", 17, parameters), 1.0) << sweeps;
  }
  for (const int sweeps : {2, 4}) {
    parameters.jacobi.sweeps = sweeps;
    EXPECT_GT(largestEnergy("one_iteration", 17, parameters), 100.0) << sweeps;
  }
}

TEST(EvenSweeps, areCalmWithTheRelaxationThatTheRuleAsksFor) {
  StepParameters parameters = with(1e3, 1.0 / 150.0);
  parameters.jacobi.relaxation = simd::evenSweepsRelaxation;
  for (const int sweeps : {2, 4}) {
    parameters.jacobi.sweeps = sweeps;
    EXPECT_LT(largestEnergy("one_iteration", 17, parameters), 2.0) << sweeps;
  }
  parameters.jacobi.relaxation = 0.9;  // (2 w - 1)^3 = 0.51 exceeds 1/3, the limit of a stable oscillator
  parameters.jacobi.sweeps = 2;
  EXPECT_GT(largestEnergy("one_iteration", 17, parameters), 100.0);
}

TEST(DerivativesUnderOneIteration, differInTheirStability) {
  const auto energy = [](ForceDerivative variant, double stiffness) {
    StepParameters parameters = with(stiffness, 1.0 / 150.0);
    parameters.derivative = variant;
    return largestEnergy("one_iteration", 17, parameters);
  };
  EXPECT_GT(energy(ForceDerivative::Exact, 1e3), 1e6);
  EXPECT_LT(energy(ForceDerivative::Stabilised, 1e3), 1.0);
  EXPECT_LT(energy(ForceDerivative::Axial, 10.0), 1.0);
  EXPECT_GT(energy(ForceDerivative::Axial, 1e3), 1e100);
  EXPECT_GT(energy(ForceDerivative::TensionOnly, 1e3), 1e3);
}

TEST(DerivativesUnderOneIteration, gainNoEnergyAndHardlyMoveWhenScalar) {
  StepParameters parameters = with(1e3, 1.0 / 150.0);
  parameters.derivative = ForceDerivative::Scalar;
  EXPECT_EQ(largestEnergy("one_iteration", 17, parameters), 0.0);
  const auto lowest = [&](ForceDerivative variant) {
    const auto model = pinnedSheet(17);
    ClothState state = stateAtRest(model->restPositions);
    parameters.derivative = variant;
    Stepper stepper("one_iteration");
    for (int step = 0; step < 70; ++step) {
      stepper.step(*model, parameters, {}, state);
    }
    return state.positions[16 * 17 + 8].y();  // the middle of the free edge
  };
  EXPECT_GT(lowest(ForceDerivative::Scalar), 0.1 * lowest(ForceDerivative::Stabilised));
}

/// The scene after 14 checkpoints of 1/30 s by velocity Verlet with small steps, written down here.
ClothState reference(const ClothModel& model, StepParameters parameters) {
  parameters.timeStep = 1.0 / 4500.0;
  const double h = parameters.timeStep;
  Workers workers;
  std::vector<Vec3> force;
  ClothState state = stateAtRest(model.restPositions);
  const auto kick = [&] {
    for (std::size_t i = 0; i < force.size(); ++i) {
      if (!model.pinned[i]) {
        state.velocities[i] += (0.5 * h / model.vertexMass[i]) * force[i];
      }
    }
  };
  testing::evaluateForces(model, parameters, {}, state, workers, force);
  for (int step = 0; step < 14 * 150; ++step) {
    kick();
    for (std::size_t i = 0; i < force.size(); ++i) {
      state.positions[i] += h * state.velocities[i];
    }
    testing::evaluateForces(model, parameters, {}, state, workers, force);
    kick();
  }
  return state;
}

/// Mean distance from the reference at the 14th checkpoint [mm].
double meanError(const char* solver, const StepParameters& parameters) {
  const auto model = pinnedSheet(17);
  const ClothState exact = reference(*model, parameters);
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper(solver);
  const auto steps = std::lround(14.0 / 30.0 / parameters.timeStep);
  for (int step = 0; step < steps; ++step) {
    stepper.step(*model, parameters, {}, state);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < exact.positions.size(); ++i) {
    sum += (state.positions[i] - exact.positions[i]).norm();
  }
  return 1000.0 * sum / static_cast<double>(exact.positions.size());
}

TEST(SecondOrder, paysWithOneSweepAsItDoesWithAnExactSolve) {
  // Stiffness [N/m], then the error of backward Euler, midpoint and BDF2 [mm].
  const double figures[][4] = {{10.0, 2.05, 0.20, 0.32}, {100.0, 14.8, 1.67, 4.08}};
  for (const auto& [stiffness, euler, midpoint, bdf2] : figures) {
    StepParameters parameters = with(stiffness, 1.0 / 1500.0);
    EXPECT_NEAR(meanError("one_iteration", parameters), euler, 0.1 * euler);
    parameters.integration = Integration::Theta;
    parameters.theta = 0.5;
    EXPECT_NEAR(meanError("one_iteration", parameters), midpoint, 0.2 * midpoint);
    parameters.integration = Integration::Bdf2;
    EXPECT_NEAR(meanError("one_iteration", parameters), bdf2, 0.2 * bdf2);
  }
}

TEST(Accuracy, ofOneIterationIsLostToTheUnfinishedSolveAtLargeSteps) {
  StepParameters parameters = with(10.0, 1.0 / 150.0);
  EXPECT_NEAR(meanError("one_iteration", parameters), 165.0, 10.0);
  EXPECT_NEAR(meanError("pcg", parameters), 10.0, 1.0);
  EXPECT_NEAR(meanError("newton", parameters), 8.5, 1.0);
  parameters.iteration.iterations = 5;
  EXPECT_NEAR(meanError("chebyshev", parameters), 20.0, 2.0);
}

TEST(OneIterationOnFineStiffMeshes, gainsEnergyFromNothing) {
  EXPECT_NEAR(largestEnergy("one_iteration", 17, with(1e3, 1.0 / 150.0)), 0.51, 0.1);
  EXPECT_NEAR(largestEnergy("one_iteration", 33, with(1e3, 1.0 / 150.0)), 3.3, 0.5);
  EXPECT_GT(largestEnergy("one_iteration", 33, with(1e3, 1.0 / 30.0)), 1e5);
}

TEST(ExactLinearSolveOnFineStiffMeshes, staysBounded) {
  StepParameters parameters = with(1e3, 1.0 / 150.0);
  parameters.iteration.tolerance = 1e-4;
  EXPECT_LT(largestEnergy("pcg", 17, parameters), 0.01);
  parameters.timeStep = 1.0 / 30.0;
  EXPECT_LT(largestEnergy("pcg", 33, parameters), 1.0);
}

/// The fraction of its momentum that a perturbed free cloth has lost after a fall of 300 steps.
double lostMomentum(const char* solver, int n, double stiffness) {
  const auto model = buildClothModel(testing::sheet(n), 0.1, MassLumping::Uniform, {});
  StepParameters parameters = with(stiffness, 1.0 / 150.0);
  parameters.iteration.tolerance = 1e-12;
  ClothState state = testing::shaken(*model, 0.002, 7);
  const auto momentum = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state.velocities.size(); ++i) {
      sum += model->vertexMass[i] * state.velocities[i];
    }
    return sum;
  };
  const Vec3 expected = momentum() + Vec3(0.0, -0.1 * parameters.gravity * 300 * parameters.timeStep, 0.0);
  Stepper stepper(solver);
  for (int step = 0; step < 300; ++step) {
    stepper.step(*model, parameters, {}, state);
  }
  return (momentum() - expected).norm() / expected.norm();
}

TEST(FreeClothsMomentum, isKeptByTheConvergedSolvers) {
  EXPECT_LT(lostMomentum("pcg", 9, 100.0), 1e-11);
  EXPECT_LT(lostMomentum("newton", 5, 100.0), 1e-12);
}

TEST(FreeClothsMomentum, isLostByOneIterationTheMoreTheStifferTheClothIs) {
  EXPECT_NEAR(lostMomentum("one_iteration", 17, 10.0), 0.20, 0.05);
  EXPECT_NEAR(lostMomentum("one_iteration", 17, 1000.0), 0.93, 0.05);
}

}  // namespace
}  // namespace drape::sim
