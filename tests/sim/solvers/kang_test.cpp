#include "dense_cloth.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

TEST(Kang, equalsTheFormulaWithDenseMatrices) {
  const auto model = unevenSheet(5, {0, 4});
  const Eigen::MatrixXd free = freedom(*model);
  for (const double maxForce : {5.0, 0.05}) {
    const StepParameters p = dampedInWind();
    const double h = p.timeStep;
    ClothState state = shaken(*model, 0.03, 7);
    const DenseAttachment pull = denseAttachment(*model, attachmentWith(maxForce), h, state);
    const Eigen::MatrixXd coupling = (h * h * p.material.stiffness + h * p.material.damping) * laplacian(*model);
    const Eigen::MatrixXd W = massMatrix(*model) + coupling + h * h * pull.stiffness;
    const Eigen::MatrixXd inverse = free * Eigen::MatrixXd(W.diagonal().cwiseInverse().asDiagonal());
    const Eigen::MatrixXd off = W - Eigen::MatrixXd(W.diagonal().asDiagonal());
    const Rows x = rowsOf(state.positions);
    const Rows v = rowsOf(state.velocities);
    const Rows impulse = h * (springForces(*model, p.material.stiffness, x) + outerForces(*model, p, state) +
                              pull.force - (p.material.damping + h * p.material.stiffness) * (laplacian(*model) * v));
    const Rows first = inverse * impulse;
    const Rows expected = v + inverse * (impulse - off * first);
    findSolver("kang")->make()->step(*model, p, attachmentWith(maxForce), state);
    EXPECT_LT(distance(state, x + h * expected, expected), 1e-12);
  }
}

TEST(Kang, equalsOneIterationWithTheScalarDerivative) {
  const auto model = unevenSheet(5, {0, 4});
  StepParameters p = dampedInWind();
  p.derivative = ForceDerivative::Scalar;
  ClothState direct = shaken(*model, 0.03, 7);
  ClothState iterated = direct;
  const auto kang = findSolver("kang")->make();
  const auto oneIteration = findSolver("one_iteration")->make();
  for (int step = 0; step < 50; ++step) {
    kang->step(*model, p, attachmentWith(5.0), direct);
    oneIteration->step(*model, p, attachmentWith(5.0), iterated);
  }
  EXPECT_LT(distance(direct, rowsOf(iterated.positions), rowsOf(iterated.velocities)), 1e-11);
}

}  // namespace
}  // namespace drape::sim
