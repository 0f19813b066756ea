#include "runge_kutta.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/stability.hpp"
#include "sim/solvers/solver.hpp"
#include "spring_chain.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

using testing::hangingChain;
using testing::pinnedSheet;
using testing::shaken;

/// A sheet whose vertices were moved within its plane, with the mass of their areas.
std::shared_ptr<const ClothModel> sheetWithMassOfAreas(int n) {
  ClothMesh mesh = testing::sheet(n);
  testing::RandomVectors random(5);
  for (Vec3& position : mesh.positions) {
    const Vec3 shift = random.next(0.3 / (n - 1));
    position += Vec3(shift.x(), 0.0, shift.z());
  }
  return buildClothModel(mesh, 0.1, MassLumping::Area, {0, n - 1});
}

/// The largest frequency of small motions about the rest shape [1/s], from the whole mesh's dense matrix.
double denseFrequency(const ClothModel& model, double stiffness) {
  const Eigen::Index size = 3 * model.vertexCount();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (const Spring& spring : model.springs) {
    const std::array<int, 2> ends{spring.a, spring.b};
    const Vec3 d = (model.restPositions[spring.b] - model.restPositions[spring.a]).normalized();
    for (const int i : ends) {
      for (const int j : ends) {
        const auto vi = static_cast<std::size_t>(i);
        const auto vj = static_cast<std::size_t>(j);
        if (!model.pinned[vi] && !model.pinned[vj]) {
          const double scale = std::sqrt(model.vertexMass[vi] * model.vertexMass[vj]);
          matrix.block<3, 3>(3 * i, 3 * j) += ((i == j ? stiffness : -stiffness) / scale) * d * d.transpose();
        }
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
  return std::sqrt(eigen.eigenvalues().maxCoeff());
}

/// The largest energy during the run [J]; infinite if the cloth blows up.
double largestEnergy(std::string_view solver, const ClothModel& model, const StepParameters& parameters, double seconds,
                     ClothState state) {
  const auto method = findSolver(solver)->make();
  double largest = -std::numeric_limits<double>::infinity();
  const int steps = static_cast<int>(seconds / parameters.timeStep);
  for (int step = 0; step < steps; ++step) {
    method->step(model, parameters, {}, state);
    if (!isFinite(state)) {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max(largest, energyOf(model, parameters, state).total());
  }
  return largest;
}

TEST(Verlet, isStableUpToTheDenseMatrixsLargestFrequencyAndNotBeyond) {
  for (const auto& model : {pinnedSheet(9), sheetWithMassOfAreas(9)}) {
    StepParameters parameters;
    parameters.gravity = 0.0;
    parameters.material.stiffness = 10.0;
    const double exact = 2.0 / denseFrequency(*model, parameters.material.stiffness);
    const ClothState start = shaken(*model, 1e-7, 3);
    const double energy = energyOf(*model, parameters, start).total();
    parameters.timeStep = 0.98 * exact;
    EXPECT_LT(largestEnergy("verlet", *model, parameters, 3.0, start), 50.0 * energy);
    parameters.timeStep = 1.02 * exact;
    EXPECT_GT(largestEnergy("verlet", *model, parameters, 3.0, start), 1e6 * energy);
  }
}

TEST(Verlet, estimatesItsLimitFromBelowAndNotFarBelow) {
  for (const auto& model : {pinnedSheet(9), pinnedSheet(12), sheetWithMassOfAreas(9), sheetWithMassOfAreas(12)}) {
    StepParameters parameters;
    const double exact = 2.0 / denseFrequency(*model, parameters.material.stiffness);
    const double estimate = findSolver("verlet")->stepLimit(*model, parameters);
    EXPECT_LE(estimate, exact);
    EXPECT_GT(estimate, 0.7 * exact);
  }
}

TEST(Verlet, isCalmBelowTheEstimatedLimitOfAFallingSheetAndGainsEnergyAbove) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  const double limit = verletStepLimit(*model, parameters);
  EXPECT_NEAR(1.0 / limit, 240.4, 0.1);
  const ClothState start = stateAtRest(model->restPositions);
  parameters.timeStep = 0.95 * limit;
  EXPECT_LT(largestEnergy("verlet", *model, parameters, 2.0, start), 1e-4) << "[J]; it starts with none";
  parameters.timeStep = 1.05 * limit;
  EXPECT_GT(largestEnergy("verlet", *model, parameters, 2.0, start), 1e-3);
  parameters.timeStep = 1.15 * limit;
  EXPECT_GT(largestEnergy("verlet", *model, parameters, 2.0, start), 1e6);
}

TEST(Verlet, staysBelowItsLimitWithDampingAndNotAbove) {
  const auto model = hangingChain(1, 0.1, 0.5);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 40.0;
  parameters.material.damping = 1.5;
  // A mass on a spring to a pin swings by 1 / sqrt(2) of the local estimate and is damped by half the rate.
  const double omega2 = parameters.material.stiffness / 0.1;
  const double c = parameters.material.damping / 0.1;
  const double exact = 4.0 / (c + std::sqrt(c * c + 4.0 * omega2));
  EXPECT_LT(verletStepLimit(*model, parameters), exact);
  ClothState start = stateAtRest(model->restPositions);
  start.positions[1].y() -= 0.01;
  const double energy = energyOf(*model, parameters, start).total();
  parameters.timeStep = 0.98 * exact;
  EXPECT_LT(largestEnergy("verlet", *model, parameters, 60.0, start), 50.0 * energy);
  parameters.timeStep = 1.02 * exact;
  EXPECT_GT(largestEnergy("verlet", *model, parameters, 60.0, start), 1e3 * energy);
}

TEST(Verlet, isReversibleInTime) {
  const auto model = pinnedSheet(5);
  const ClothState start = shaken(*model, 0.03, 7);
  ClothState state = start;
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  const auto solver = findSolver("verlet")->make();
  const auto turn = [&] {
    std::for_each(state.velocities.begin(), state.velocities.end(), [](Vec3& velocity) { velocity = -velocity; });
  };
  for (int half = 0; half < 2; ++half) {
    for (int step = 0; step < 50; ++step) {
      solver->step(*model, parameters, {}, state);
    }
    turn();
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - start.positions[v]).norm(), 1e-11);
    EXPECT_LT((state.velocities[v] - start.velocities[v]).norm(), 1e-9);
  }
}

TEST(Verlet, keepsTheAngularMomentumOfFreeCloth) {
  const auto model = buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {});
  ClothState state = shaken(*model, 0.03, 9);
  const auto spin = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
      sum += model->vertexMass[v] * state.positions[v].cross(state.velocities[v]);
    }
    return sum;
  };
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 10.0;
  const Vec3 before = spin();
  const auto solver = findSolver("verlet")->make();
  for (int step = 0; step < 300; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  EXPECT_LT((spin() - before).norm(), 1e-12 * (1.0 + before.norm()));
}

TEST(Verlet, isWithinAQuarterMillimetreOnSoftClothAndExplodesOnStiffAtTheSameStep) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.timeStep = 1.0 / 300.0;
  parameters.material.stiffness = 10.0;
  const int steps = 140;
  const std::vector<Vec3> reference = testing::rungeKutta(*model, parameters.material.stiffness, 14.0 / 30.0, 1400);
  const auto solver = findSolver("verlet")->make();
  ClothState state = stateAtRest(model->restPositions);
  for (int step = 0; step < steps; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  double error = 0.0;
  for (std::size_t v = 0; v < reference.size(); ++v) {
    error += (state.positions[v] - reference[v]).norm() / static_cast<double>(reference.size());
  }
  EXPECT_NEAR(error, 0.25e-3, 0.02e-3) << "[m]";
  parameters.material.stiffness = 100.0;
  EXPECT_GT(largestEnergy("verlet", *model, parameters, 14.0 / 30.0, stateAtRest(model->restPositions)), 1e6);
}

TEST(Verlet, bringsTheClothToAnAttachmentThatIsFarStifferThanTheCloth) {
  const auto model = buildClothModel(testing::sheet(9), 0.01, MassLumping::Uniform, {0, 8});
  StepParameters parameters;
  parameters.material.stiffness = 1.0;
  parameters.material.damping = 1e-3;
  parameters.timeStep = 0.9 * verletStepLimit(*model, parameters);
  StepInputs inputs;
  inputs.attachment = Attachment{{100, Vec3(0.2, 0.3, 0.5), Vec3(0.6, 0.4, 0.8)}, {500.0, 20.0}};
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = findSolver("verlet")->make();
  for (int step = 0; step < 2000; ++step) {
    solver->step(*model, parameters, inputs, state);
    ASSERT_TRUE(isFinite(state));
  }
  Vec3 attached = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    attached +=
        inputs.attachment->barycentric[static_cast<Eigen::Index>(c)] * state.positions[model->triangles[100][c]];
  }
  EXPECT_LT((attached - inputs.attachment->target).norm(), 0.01);
}

TEST(Verlet, saysHowManySubstepsAreNeededAndIsContentWithThem) {
  const auto model = pinnedSheet(17);
  const SolverInfo& info = *findSolver("verlet");
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  parameters.timeStep = 1.0 / 150.0;
  const SolverWarning warning = info.warning(*model, parameters).value();
  EXPECT_EQ(warning.kind, SolverWarning::Kind::StepTooLong);
  EXPECT_EQ(warning.seconds, info.stepLimit(*model, parameters));
  EXPECT_EQ(std::ceil(1.0 / warning.seconds), 241.0);
  EXPECT_EQ(warning.substeps, 2.0);
  parameters.substeps = 2;
  EXPECT_FALSE(info.warning(*model, parameters));
  parameters.timeStep = warning.seconds;
  parameters.substeps = 1;
  EXPECT_FALSE(info.warning(*model, parameters)) << "the step that was named must do";
  parameters.material.stiffness = 1e9;
  EXPECT_GT(info.warning(*model, parameters).value().substeps, 1000.0) << "more than the settings allow";
}

TEST(ExplicitEuler, growsAnUndampedOscillatorsEnergyByOnePlusHOmegaSquaredInEveryStep) {
  const auto model = hangingChain(1, 0.1, 0.5);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 40.0;
  parameters.timeStep = 1e-3;
  ClothState state = stateAtRest(model->restPositions);
  state.positions[1].y() -= 0.01;
  const auto solver = findSolver("explicit_euler")->make();
  const double growth = 1.0 + 1e-6 * parameters.material.stiffness / 0.1;
  for (int step = 0; step < 100; ++step) {
    const double before = energyOf(*model, parameters, state).total();
    solver->step(*model, parameters, {}, state);
    EXPECT_NEAR(energyOf(*model, parameters, state).total() / before, growth, 1e-11);
  }
}

TEST(ExplicitEuler, isStableUpToItsLimitWithDampingAndNotBeyond) {
  const auto model = hangingChain(1, 0.1, 0.5);
  const SolverInfo& info = *findSolver("explicit_euler");
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.material.stiffness = 40.0;
  parameters.material.damping = 0.4;
  const double limit = info.stepLimit(*model, parameters);
  EXPECT_DOUBLE_EQ(limit, parameters.material.damping / parameters.material.stiffness);
  ClothState start = stateAtRest(model->restPositions);
  start.positions[1].y() -= 0.01;
  const double energy = energyOf(*model, parameters, start).total();
  parameters.timeStep = 0.98 * limit;
  EXPECT_LT(largestEnergy("explicit_euler", *model, parameters, 60.0, start), 3.0 * energy);
  EXPECT_FALSE(info.warning(*model, parameters));
  parameters.timeStep = 1.02 * limit;
  EXPECT_GT(largestEnergy("explicit_euler", *model, parameters, 60.0, start), 20.0 * energy);
  EXPECT_TRUE(info.warning(*model, parameters));
}

TEST(ExplicitEuler, isStableBelowItsLimitOnADampedSheet) {
  for (const double damping : {1e-3, 1e-2, 0.1}) {
    const auto model = sheetWithMassOfAreas(9);
    StepParameters parameters;
    parameters.gravity = 0.0;
    parameters.material.stiffness = 10.0;
    parameters.material.damping = damping;
    parameters.timeStep = 0.98 * findSolver("explicit_euler")->stepLimit(*model, parameters);
    const ClothState start = shaken(*model, 1e-7, 3);
    const double energy = energyOf(*model, parameters, start).total();
    EXPECT_LT(largestEnergy("explicit_euler", *model, parameters, 0.5, start), 20.0 * energy) << damping;
  }
}

TEST(ExplicitEuler, hasNoStableStepWithoutDampingAndSaysHowFastEnergyDoubles) {
  const auto model = pinnedSheet(17);
  const SolverInfo& info = *findSolver("explicit_euler");
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  parameters.timeStep = 1e-4;
  EXPECT_EQ(info.stepLimit(*model, parameters), 0.0);
  // ln 2 / (h omega^2), omega = 480.8 / s
  EXPECT_EQ(info.warning(*model, parameters).value().kind, SolverWarning::Kind::GainsEnergy);
  EXPECT_NEAR(info.warning(*model, parameters)->seconds, 0.03, 0.0005);
  parameters.material.stiffness = 0.0;
  EXPECT_EQ(info.stepLimit(*model, parameters), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(info.warning(*model, parameters));
}

}  // namespace
}  // namespace drape::sim
