#include "sim/measures/residuals.hpp"

#include "all_forces.hpp"
#include "sim/systems/implicit_system.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <cmath>

namespace drape::sim {
namespace {

StepParameters dampedInSideWind() {
  StepParameters parameters;
  parameters.material.stiffness = 200.0;
  parameters.material.damping = 0.01;
  parameters.air.drag = 0.5;
  parameters.air.wind = Vec3(1.0, 0.0, 2.0);
  return parameters;
}

StepInputs attachmentOnTriangle(int triangle) {
  StepInputs inputs;
  inputs.attachment = Attachment{{triangle, Vec3(0.2, 0.3, 0.5), Vec3(0.5, 1.0, 1.0)}, {50.0, 2.0}};
  return inputs;
}

/// The exact solution of W dv = h f~ from a dense matrix that is built column by column; pinned rows are dv = 0.
std::vector<Vec3> denseSolution(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                const ClothState& state) {
  Workers workers;
  ImplicitSystem system;
  system.assemble(model, parameters, inputs, state, workers);
  const auto count = static_cast<Eigen::Index>(3 * state.positions.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
  Eigen::VectorXd side = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    if (model.pinned[i]) {
      continue;
    }
    const auto row = static_cast<Eigen::Index>(3 * i);
    side.segment<3>(row) = system.rightHandSide()[i];
    for (Eigen::Index column = 0; column < count; ++column) {
      std::vector<Vec3> unit(state.positions.size(), Vec3::Zero());
      unit[column / 3][column % 3] = 1.0;
      matrix.block<3, 1>(row, column) = system.row(model, parameters, unit, i);
    }
  }
  const Eigen::VectorXd solution = matrix.lu().solve(side);
  std::vector<Vec3> dv(state.positions.size());
  for (std::size_t i = 0; i < dv.size(); ++i) {
    dv[i] = solution.segment<3>(static_cast<Eigen::Index>(3 * i));
  }
  return dv;
}

/// |h f~ - W dv| / |h f~| over free vertices, with dv the change of velocity: the residual of the linear system about
/// `before` [-].
double linearResidual(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                      const ClothState& before, const ClothState& after) {
  Workers workers;
  ImplicitSystem system;
  system.assemble(model, parameters, inputs, before, workers);
  std::vector<Vec3> dv(after.velocities.size(), Vec3::Zero());
  for (std::size_t i = 0; i < dv.size(); ++i) {
    if (!model.pinned[i]) {
      dv[i] = after.velocities[i] - before.velocities[i];
    }
  }
  double residual = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < dv.size(); ++i) {
    if (!model.pinned[i]) {
      residual += (system.rightHandSide()[i] - system.row(model, parameters, dv, i)).squaredNorm();
      scale += system.rightHandSide()[i].squaredNorm();
    }
  }
  return scale > 0.0 ? std::sqrt(residual / scale) : std::sqrt(residual);
}

TEST(ImplicitSystem, hasNoResidualForTheDenseSolutionAndOneThatGrowsWithWhatIsMissing) {
  const auto model = testing::pinnedSheet(4);
  const StepParameters parameters = dampedInSideWind();
  const StepInputs inputs = attachmentOnTriangle(8);
  const ClothState before = testing::shaken(*model, 0.05, 7);
  std::vector<Vec3> dv = denseSolution(*model, parameters, inputs, before);
  ClothState after = before;
  advance(*model, parameters.timeStep, dv, after);
  EXPECT_LT(linearResidual(*model, parameters, inputs, before, after), 1e-12);
  for (Vec3& change : dv) {
    change *= 0.75;  // the system is linear: a quarter of the answer is missing, a quarter of the right-hand side left
  }
  ClothState partly = before;
  advance(*model, parameters.timeStep, dv, partly);
  EXPECT_NEAR(linearResidual(*model, parameters, inputs, before, partly), 0.25, 1e-12);
}

TEST(ImplicitSystem, hasAResidualOfOneWhereTheVelocityDidNotChange) {
  const auto model = testing::pinnedSheet(4);
  const ClothState before = testing::shaken(*model, 0.05, 7);
  EXPECT_DOUBLE_EQ(linearResidual(*model, dampedInSideWind(), {}, before, before), 1.0);
}

TEST(NonlinearResidual, isZeroForClothAtRestOnWhichNothingActs) {
  const auto model = testing::pinnedSheet(4);
  StepParameters parameters;
  parameters.gravity = 0.0;
  const ClothState state = stateAtRest(model->restPositions);
  EXPECT_EQ(linearResidual(*model, parameters, {}, state, state), 0.0);
  EXPECT_EQ(nonlinearResidual(*model, parameters, {}, state, state), 0.0);
}

TEST(NonlinearResidual, vanishesForTheFixedPointOfTheImplicitEquations) {
  const auto model = testing::pinnedSheet(4);
  StepParameters parameters = dampedInSideWind();
  parameters.timeStep = 1e-4;  // so small that the plain iteration below contracts
  const StepInputs inputs = attachmentOnTriangle(8);
  const ClothState before = testing::shaken(*model, 0.05, 7);
  StepParameters airless = parameters;
  airless.air.drag = 0.0;
  Workers workers;
  std::vector<Vec3> force;
  std::vector<Vec3> air;
  std::vector<Vec3> airlessForce;
  testing::evaluateForces(*model, parameters, inputs, before, workers, air);
  testing::evaluateForces(*model, airless, inputs, before, workers, airlessForce);
  ClothState after = before;
  for (int iteration = 0; iteration < 30; ++iteration) {
    testing::evaluateForces(*model, airless, inputs, after, workers, force);
    std::vector<Vec3> dv(force.size());
    for (std::size_t i = 0; i < dv.size(); ++i) {
      dv[i] = parameters.timeStep / model->vertexMass[i] * (force[i] + air[i] - airlessForce[i]);
    }
    after = before;
    advance(*model, parameters.timeStep, dv, after);
  }
  EXPECT_LT(nonlinearResidual(*model, parameters, inputs, before, after), 1e-12);
}

TEST(NonlinearResidual, isOneForCoasting) {
  const auto model = testing::pinnedSheet(4);
  const StepParameters parameters = dampedInSideWind();
  const ClothState before = testing::shaken(*model, 0.05, 7);
  ClothState after = before;
  advance(*model, parameters.timeStep, std::vector<Vec3>(after.positions.size(), Vec3::Zero()), after);
  EXPECT_DOUBLE_EQ(nonlinearResidual(*model, parameters, {}, before, after), 1.0);
}

}  // namespace
}  // namespace drape::sim
