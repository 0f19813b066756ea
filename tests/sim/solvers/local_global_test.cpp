#include "dense_cloth.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

/// M (y - x_n), with the attachment's force.
Rows inertiaTerm(const ClothModel& model, const StepParameters& p, const DenseAttachment& pull,
                 const ClothState& state) {
  const double h = p.timeStep;
  const Rows v = rowsOf(state.velocities);
  // The attachment's force uses the displacement of the attached point; its stiffness acts on that of each corner.
  return h * massMatrix(model) * v + h * h * (outerForces(model, p, state) + pull.force) +
         h * h * h * pull.stiffness * v;
}

/// The method as printed: absolute positions, x and d in turn.
Rows alternate(const ClothModel& model, const StepParameters& p, const StepInputs& inputs, const ClothState& state) {
  const double h = p.timeStep;
  const DenseAttachment pull = denseAttachment(model, inputs, h, state);
  const Eigen::MatrixXd M = massMatrix(model);
  const Eigen::MatrixXd L = laplacian(model);
  const Rows x0 = rowsOf(state.positions);
  const Rows inertia = inertiaTerm(model, p, pull, state);
  const Eigen::MatrixXd A = M + (h * h * p.material.stiffness + h * p.material.damping) * L + h * h * pull.stiffness;
  Rows x = x0 + freedom(model) * (M.inverse() * (inertiaTerm(model, p, denseAttachment(model, {}, h, state), state)));
  for (int iteration = 0; iteration < p.iteration.iterations; ++iteration) {
    Rows right = M * x0 + inertia + h * p.material.damping * L * x0 + h * h * pull.stiffness * x0;
    for (const Spring& s : model.springs) {
      const Eigen::RowVector3d d = s.restLength * (x.row(s.b) - x.row(s.a)).normalized();
      right.row(s.a) -= h * h * p.material.stiffness * d;
      right.row(s.b) += h * h * p.material.stiffness * d;
    }
    const Eigen::MatrixXd fixed = Eigen::MatrixXd::Identity(A.rows(), A.cols()) - freedom(model);
    x = fixed * x0 + solveFree(model, A, right - A * fixed * x0);
  }
  return x;
}

/// The end of a backward-Euler step by Newton's method with the exact derivative, 3n x 3n.
Rows newton(const ClothModel& model, const StepParameters& p, const StepInputs& inputs, const ClothState& state) {
  const double h = p.timeStep;
  const Eigen::Index n = model.vertexCount();
  const DenseAttachment pull = denseAttachment(model, inputs, h, state);
  const Eigen::MatrixXd scalar = massMatrix(model) + h * p.material.damping * laplacian(model) + h * h * pull.stiffness;
  const Rows x0 = rowsOf(state.positions);
  const Rows inertia = inertiaTerm(model, p, pull, state);
  const Eigen::MatrixXd free = freedom(model);
  Rows x = x0;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Rows residual = free * (inertia + h * h * springForces(model, p.material.stiffness, x) - scalar * (x - x0));
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        matrix.block<3, 3>(3 * i, 3 * j) = scalar(i, j) * Mat3::Identity();
      }
    }
    for (const Spring& s : model.springs) {
      const Vec3 offset = (x.row(s.b) - x.row(s.a)).transpose();
      const double ratio = s.restLength / offset.norm();
      const Vec3 d = offset.normalized();
      const Mat3 block = h * h * p.material.stiffness * ((1.0 - ratio) * Mat3::Identity() + ratio * d * d.transpose());
      matrix.block<3, 3>(3 * s.a, 3 * s.a) += block;
      matrix.block<3, 3>(3 * s.b, 3 * s.b) += block;
      matrix.block<3, 3>(3 * s.a, 3 * s.b) -= block;
      matrix.block<3, 3>(3 * s.b, 3 * s.a) -= block;
    }
    Eigen::VectorXd right(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      right.segment<3>(3 * i) = residual.row(i).transpose();
      if (free(i, i) == 0.0) {
        matrix.middleRows(3 * i, 3).setZero();
        matrix.block<3, 3>(3 * i, 3 * i).setIdentity();
      }
    }
    const Eigen::VectorXd change = matrix.partialPivLu().solve(right);
    for (Eigen::Index i = 0; i < n; ++i) {
      x.row(i) += change.segment<3>(3 * i).transpose();
    }
  }
  return x;
}

TEST(LocalGlobal, equalsTheAlternationAsPrintedWithDenseMatrices) {
  for (const std::vector<int>& pins : {std::vector<int>{0, 4}, std::vector<int>{}}) {
    const auto model = unevenSheet(5, pins);
    for (const StepInputs& inputs : {StepInputs{}, attachmentWith(5.0), attachmentWith(0.05)}) {
      StepParameters p = dampedInWind();
      p.iteration.iterations = 4;
      ClothState state = shaken(*model, 0.03, 7);
      const Rows x = rowsOf(state.positions);
      const Rows expected = alternate(*model, p, inputs, state);
      findSolver("local_global")->make()->step(*model, p, inputs, state);
      EXPECT_LT(distance(state, expected, (expected - x) / p.timeStep), 1e-11);
    }
  }
}

TEST(LocalGlobal, endsWhereNewtonFindsTheBackwardEulerStep) {
  const auto model = unevenSheet(5, {0, 4});
  for (const StepInputs& inputs : {StepInputs{}, attachmentWith(5.0)}) {
    StepParameters p = dampedInWind();
    p.iteration.iterations = 3000;
    ClothState state = shaken(*model, 0.01, 7);
    const Rows expected = newton(*model, p, inputs, state);
    findSolver("local_global")->make()->step(*model, p, inputs, state);
    EXPECT_LT((rowsOf(state.positions) - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(LocalGlobal, comesCloserToTheBackwardEulerStepWithEveryIteration) {
  const auto model = unevenSheet(5, {0, 4});
  StepParameters p = dampedInWind();
  p.material.stiffness = 1000.0;
  const ClothState start = shaken(*model, 0.01, 7);
  const Rows exact = newton(*model, p, {}, start);
  double last = 1.0;
  for (const int iterations : {1, 5, 20, 100}) {
    p.iteration.iterations = iterations;
    ClothState state = start;
    const StepReport report = findSolver("local_global")->make()->step(*model, p, {}, state);
    const double error = (rowsOf(state.positions) - exact).norm();
    EXPECT_LT(error, 0.8 * last) << iterations << " iterations";
    EXPECT_EQ(report.iterations, iterations);
    last = error;
  }
}

TEST(LocalGlobal, forgetsAReleasedAttachmentAndFollowsOneAtAnotherTriangle) {
  const auto model = unevenSheet(5, {0, 4});
  const StepParameters p = dampedInWind();
  ClothState fresh = shaken(*model, 0.03, 7);
  ClothState kept = fresh;
  const auto solver = findSolver("local_global")->make();
  StepInputs elsewhere = attachmentWith(5.0);
  elsewhere.attachment->triangle = 20;
  for (const StepInputs& inputs : {attachmentWith(5.0), elsewhere, StepInputs{}, attachmentWith(5.0)}) {
    solver->step(*model, p, inputs, kept);
    findSolver("local_global")->make()->step(*model, p, inputs, fresh);
    EXPECT_EQ(stateHash(kept), stateHash(fresh));
  }
}

}  // namespace
}  // namespace drape::sim
