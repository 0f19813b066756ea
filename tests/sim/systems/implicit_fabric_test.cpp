#include "fabric_cloths.hpp"
#include "sim/forces/forces.hpp"
#include "sim/solvers/step_parameters.hpp"
#include "sim/systems/implicit_system.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace drape::sim {
namespace {

using namespace testing;

/// All positions or velocities in one vector.
Eigen::VectorXd flattened(const std::vector<Vec3>& vectors) {
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(3 * vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    numbers.segment<3>(static_cast<Eigen::Index>(3 * i)) = vectors[i];
  }
  return numbers;
}

/// The elastic forces [N].
Eigen::VectorXd forcesAt(const ClothModel& model, const std::vector<Vec3>& positions) {
  std::vector<Vec3> forces;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    forces.push_back(fabric::elasticForceOn(model, positions, v));
  }
  return flattened(forces);
}

/// The derivative of the forces along a change of the positions, by differences [N].
Eigen::VectorXd changeOfForces(const ClothModel& model, const ClothState& state, const std::vector<Vec3>& change) {
  constexpr double step = 1e-6;
  std::vector<Vec3> after = state.positions;
  std::vector<Vec3> before = state.positions;
  for (std::size_t v = 0; v < after.size(); ++v) {
    after[v] += step * change[v];
    before[v] -= step * change[v];
  }
  return (forcesAt(model, after) - forcesAt(model, before)) / (2.0 * step);
}

struct LinearisedStep {
  std::shared_ptr<const ClothModel> model = asFabric(*irregularSheet(6), woven());
  StepParameters parameters;
  ClothState state = shaken(*model, 0.01, 3);
  ImplicitSystem system;
  Workers workers;

  LinearisedStep() {
    parameters.timeStep = 0.01;
    parameters.gravity = 0.0;
    parameters.air = {};
    parameters.derivative = ForceDerivative::Exact;
    system.assemble(*model, parameters, {}, state, workers);
  }
  [[nodiscard]] Eigen::VectorXd times(const std::vector<Vec3>& vectors) const {
    std::vector<Vec3> rows;
    for (std::size_t v = 0; v < vectors.size(); ++v) {
      rows.push_back(system.row(*model, parameters, vectors, v));
    }
    return flattened(rows);
  }
};

TEST(ImplicitFabric, hasTheMatrixOfTheLinearisedStep) {
  const LinearisedStep setup;
  const std::vector<Vec3> change = shaken(*setup.model, 1.0, 9).velocities;
  std::vector<Vec3> momentum = change;
  for (std::size_t v = 0; v < momentum.size(); ++v) {
    momentum[v] *= setup.model->vertexMass[v];
  }
  const double h = setup.parameters.timeStep;
  const Eigen::VectorXd expected = flattened(momentum) - h * h * changeOfForces(*setup.model, setup.state, change);
  EXPECT_LT((setup.times(change) - expected).norm(), 1e-7 * expected.norm());
}

TEST(ImplicitFabric, hasTheRightHandSideOfTheLinearisedStep) {
  const LinearisedStep setup;
  const double h = setup.parameters.timeStep;
  const Eigen::VectorXd expected = h * (forcesAt(*setup.model, setup.state.positions) +
                                        h * changeOfForces(*setup.model, setup.state, setup.state.velocities));
  EXPECT_LT((flattened(setup.system.rightHandSide()) - expected).norm(), 1e-7 * expected.norm());
}

/// Block Jacobi with the surplus must not overshoot by more than a factor of two, however long the step is.
TEST(ImplicitFabric, keepsTheEigenvaluesOfBlockJacobiAboveMinusOne) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    LinearisedStep setup;
    setup.model = asFabric(*irregularSheet(6), material);
    setup.parameters.timeStep = 10.0;
    setup.parameters.derivative = ForceDerivative::Stabilised;
    setup.system.assemble(*setup.model, setup.parameters, {}, setup.state, setup.workers);
    const auto size = static_cast<Eigen::Index>(3 * setup.state.positions.size());
    Eigen::MatrixXd matrix(size, size);
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      std::vector<Vec3> unit(setup.state.positions.size(), Vec3::Zero());
      unit[static_cast<std::size_t>(i / 3)][i % 3] = 1.0;
      matrix.col(i) = setup.times(unit);
    }
    for (std::size_t v = 0; v < setup.state.positions.size(); ++v) {
      const auto at = static_cast<Eigen::Index>(3 * v);
      blocks.block<3, 3>(at, at) = setup.system.diagonal()[v] + setup.system.jacobiSurplus()[v];
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(0.5 * (matrix + matrix.transpose()), blocks,
                                                                          Eigen::EigenvaluesOnly);
    EXPECT_LT(modes.eigenvalues().maxCoeff(), 2.0 + 1e-9) << name;  // the eigenvalue of Jacobi is 1 minus this
    EXPECT_GT(modes.eigenvalues().maxCoeff(), 1.2) << name;         // and not much larger blocks than needed
    EXPECT_GT(modes.eigenvalues().minCoeff(), 0.0) << name;
  }
}

TEST(ImplicitFabric, hasTheSameBitsWithAnyNumberOfThreads) {
  LinearisedStep one;
  LinearisedStep three;
  three.parameters.threads = 3;
  three.system.assemble(*three.model, three.parameters, {}, three.state, three.workers);
  for (std::size_t v = 0; v < one.state.positions.size(); ++v) {
    EXPECT_EQ(one.system.rightHandSide()[v], three.system.rightHandSide()[v]);
    EXPECT_EQ(one.system.diagonal()[v], three.system.diagonal()[v]);
  }
}

}  // namespace
}  // namespace drape::sim
