#include "sim/systems/constant_filter.hpp"

#include "dense_cloth.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

Vec3 barycentre(const ClothModel& model, const Rows& x) {
  return x.transpose() * massMatrix(model).diagonal() / model.totalMass();
}

/// What a solver of this family should do, with dense matrices: x and v at the end of the step.
struct Expected {
  Rows x;
  Rows v;
};

Expected filteredStep(const ClothModel& model, const StepParameters& p, const StepInputs& inputs,
                      const ClothState& state, bool correctVelocities) {
  const double h = p.timeStep;
  const Eigen::MatrixXd M = massMatrix(model);
  const Eigen::MatrixXd L = laplacian(model);
  const DenseAttachment pull = denseAttachment(model, inputs, h, state);
  const Rows x = rowsOf(state.positions);
  const Rows v = rowsOf(state.velocities);
  const Rows internal =
      springForces(model, p.material.stiffness, x) - (p.material.damping + h * p.material.stiffness) * (L * v);
  const Eigen::MatrixXd A = M + (h * h * p.material.stiffness + h * p.material.damping) * L + h * h * pull.stiffness;
  const Rows dv = solveFree(model, A, h * (internal + pull.force));
  Rows rotation = Rows::Zero(x.rows(), 3);
  if (freedom(model).trace() == static_cast<double>(model.vertexCount())) {
    const Rows r = x.rowwise() - barycentre(model, x).transpose();
    const Rows spurious = M * dv - h * pull.force + h * h * pull.stiffness * dv;
    Mat3 inertia = Mat3::Zero();
    Vec3 torque = Vec3::Zero();
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      const Vec3 arm = r.row(i).transpose();
      inertia += M(i, i) * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
      torque += arm.cross(Vec3(spurious.row(i).transpose()));
    }
    const Vec3 spin = -inertia.inverse() * torque;
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      rotation.row(i) = spin.cross(Vec3(r.row(i).transpose())).transpose();
    }
  }
  const Rows plain = freedom(model) * (v + dv + h * M.inverse() * outerForces(model, p, state));
  const Rows corrected = plain + rotation;
  return {x + h * corrected, correctVelocities ? corrected : plain};
}

double differenceFromDense(const char* solver, const std::vector<int>& pins, const StepInputs& inputs) {
  const auto model = unevenSheet(5, pins);
  ClothState state = shaken(*model, 0.03, 7);
  const Expected expected = filteredStep(*model, dampedInWind(), inputs, state, std::string_view(solver) == "meyer");
  findSolver(solver)->make()->step(*model, dampedInWind(), inputs, state);
  return distance(state, expected.x, expected.v);
}

TEST(Desbrun, equalsTheDenseStepOfAPinnedCloth) {
  EXPECT_LT(differenceFromDense("desbrun", {0, 4}, {}), 1e-12);
  EXPECT_LT(differenceFromDense("desbrun", {0, 4}, attachmentWith(5.0)), 1e-12);
  EXPECT_LT(differenceFromDense("desbrun", {0, 4}, attachmentWith(0.05)), 1e-12);
}

TEST(Desbrun, equalsTheDenseStepOfAFreeClothWithTheCorrectionOnPositions) {
  EXPECT_LT(differenceFromDense("desbrun", {}, {}), 1e-11);
  EXPECT_LT(differenceFromDense("desbrun", {}, attachmentWith(5.0)), 1e-11);
}

TEST(Meyer, equalsTheDenseStepOfAFreeClothWithTheCorrectionOnVelocities) {
  EXPECT_LT(differenceFromDense("meyer", {}, {}), 1e-11);
  EXPECT_LT(differenceFromDense("meyer", {}, attachmentWith(5.0)), 1e-11);
}

TEST(Meyer, movesAPinnedClothAsDesbrunDoesToTheLastBit) {
  const auto model = unevenSheet(5, {0, 4});
  ClothState one = shaken(*model, 0.03, 7);
  ClothState other = one;
  const auto meyer = findSolver("meyer")->make();
  const auto desbrun = findSolver("desbrun")->make();
  for (int step = 0; step < 50; ++step) {
    meyer->step(*model, dampedInWind(), {}, one);
    desbrun->step(*model, dampedInWind(), {}, other);
  }
  EXPECT_EQ(stateHash(one), stateHash(other));
}

/// Of the relative change in a second of a free, spinning and shaken cloth in empty space.
struct MomentumLoss {
  double linear = 0.0;
  double angular = 0.0;
};

MomentumLoss lossOfSpinning(const char* solver) {
  const auto model = unevenSheet(9, {});
  ClothState state = shaken(*model, 0.01, 5);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] += Vec3(1.0, 0.5, 0.2) + Vec3(0.3, 2.0, 1.0).cross(state.positions[v]);
  }
  StepParameters p;
  p.gravity = 0.0;
  const auto angular = [&] { return angularMomentum(*model, state, barycentre(*model, rowsOf(state.positions))); };
  const Vec3 linearBefore = linearMomentum(*model, state);
  const Vec3 angularBefore = angular();
  const auto method = findSolver(solver)->make();
  for (int step = 0; step < 150; ++step) {
    method->step(*model, p, {}, state);
  }
  return {(linearMomentum(*model, state) - linearBefore).norm() / linearBefore.norm(),
          (angular() - angularBefore).norm() / angularBefore.norm()};
}

TEST(Meyer, keepsLinearAndAngularMomentumOfAFreeCloth) {
  const MomentumLoss loss = lossOfSpinning("meyer");
  EXPECT_LT(loss.linear, 1e-10);
  EXPECT_LT(loss.angular, 1e-10);
}

TEST(Desbrun, keepsTheLinearMomentumOfAFreeClothButStopsItsSpin) {
  const MomentumLoss loss = lossOfSpinning("desbrun");
  EXPECT_LT(loss.linear, 1e-10);
  EXPECT_GT(loss.angular, 0.9) << "a correction of positions alone does not reach the velocities";
}

TEST(Desbrun, hangsLowerByTheWeightThatItsMatrixPutsOnASpring) {
  const auto model = pair({0});
  StepParameters p;
  p.timeStep = 1.0 / 50.0;
  p.material.damping = 0.5;
  ClothState state = stateAtRest({Vec3(0.0, 0.0, 0.0), Vec3(0.0, -1.0, 0.0)});
  const auto solver = findSolver("desbrun")->make();
  for (int step = 0; step < 2000; ++step) {
    solver->step(*model, p, {}, state);
  }
  const double h = p.timeStep;
  const double weight = model->vertexMass[1] * p.gravity / p.material.stiffness;
  const double added = (h * h + h * p.material.damping / p.material.stiffness) * p.gravity;
  EXPECT_NEAR(-1.0 - state.positions[1].y(), weight + added, 1e-9);
}

TEST(ConstantFilter, givesTheSameWithTheDenseInverseAsWithTheSparseFactor) {
  const auto model = unevenSheet(13, {0, 12});
  Workers workers;
  RandomVectors random(3);
  std::vector<Vec3> dense(model->restPositions.size());
  for (Vec3& impulse : dense) {
    impulse = random.next(1.0);
  }
  std::vector<Vec3> sparse = dense;
  AttachmentDiagonal attachment{{5, 0, 40}, Vec3(0.01, 0.02, 0.03)};
  ConstantFilter one;
  one.prepare(*model, {1.0, 0.02, 0.0}, &attachment);
  one.apply(1, workers, dense);
  ConstantFilter other(10);
  other.prepare(*model, {1.0, 0.02, 0.0}, &attachment);
  other.apply(1, workers, sparse);
  const Rows difference = rowsOf(dense) - rowsOf(sparse);
  EXPECT_LT(difference.norm(), 1e-11 * rowsOf(sparse).norm());
  EXPECT_GT(rowsOf(sparse).norm(), 1.0);
}

TEST(ConstantFilter, followsANewWeightNewPinsAndAnotherModel) {
  const auto model = unevenSheet(5, {0, 4});
  std::vector<bool> pinned = model->pinned;
  pinned[12] = true;
  const auto other = withPins(*model, pinned);
  const auto heavier = withMass(*model, 0.3, MassLumping::Area);
  Workers workers;
  RandomVectors random(3);
  std::vector<Vec3> impulses(model->restPositions.size());
  for (Vec3& impulse : impulses) {
    impulse = random.next(1.0);
  }
  ConstantFilter filter;
  for (const auto& [cloth, weight] : std::vector<std::pair<std::shared_ptr<const ClothModel>, double>>{
           {model, 0.01}, {model, 0.05}, {other, 0.05}, {heavier, 0.05}, {model, 0.01}}) {
    std::vector<Vec3> changes = impulses;
    filter.prepare(*cloth, {1.0, weight, 0.0}, nullptr);
    filter.apply(1, workers, changes);
    const Rows expected = solveFree(*cloth, massMatrix(*cloth) + weight * laplacian(*cloth), rowsOf(impulses));
    EXPECT_LT((rowsOf(changes) - expected).norm(), 1e-11 * expected.norm());
  }
}

}  // namespace
}  // namespace drape::sim
