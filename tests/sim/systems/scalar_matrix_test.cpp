#include "dense_cloth.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/motion/momentum.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

/// Properties of all methods whose matrix has the spring constant as the whole derivative.
class ScalarMatrixSolver : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::unique_ptr<Solver> make() const { return findSolver(GetParam())->make(); }

  [[nodiscard]] ClothState run(const ClothModel& model, const StepParameters& p, int steps, ClothState state) const {
    const auto solver = make();
    for (int step = 0; step < steps; ++step) {
      solver->step(model, p, {}, state);
    }
    return state;
  }
};

INSTANTIATE_TEST_SUITE_P(Each, ScalarMatrixSolver, ::testing::Values("kang", "desbrun", "meyer", "local_global"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST_P(ScalarMatrixSolver, leavesAClothAtRestWithoutForcesWhereItIs) {
  for (const std::vector<int>& pins : {std::vector<int>{0, 8}, std::vector<int>{}}) {
    const auto model = unevenSheet(9, pins);
    StepParameters p;
    p.gravity = 0.0;
    p.air.drag = 1.0;
    p.air.lift = 1.0;
    p.material.damping = 0.1;
    const ClothState state = run(*model, p, 100, stateAtRest(model->restPositions));
    EXPECT_LT(distance(state, rowsOf(model->restPositions), Rows::Zero(81, 3)), 1e-12);
  }
}

TEST_P(ScalarMatrixSolver, keepsPinnedVerticesAndLetsTheRestFall) {
  const auto model = pinnedSheet(9);
  StepParameters p;
  p.material.stiffness = 10.0;
  const ClothState state = run(*model, p, 200, stateAtRest(model->restPositions));
  EXPECT_EQ(state.positions[0], model->restPositions[0]);
  EXPECT_EQ(state.velocities[8], Vec3(Vec3::Zero()));
  EXPECT_LT(state.positions[80].y(), -0.2);
  EXPECT_NEAR(state.time, 200.0 / 150.0, 1e-12);
}

TEST_P(ScalarMatrixSolver, letsSpringlessClothFallByBackwardEulersClosedForm) {
  const auto model = unevenSheet(5, {});
  StepParameters p;
  p.material.stiffness = 0.0;
  const int steps = 30;
  const ClothState state = run(*model, p, steps, stateAtRest(model->restPositions));
  const double h = p.timeStep;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3 fall(0.0, -0.5 * p.gravity * h * h * steps * (steps + 1), 0.0);
    EXPECT_LT((state.positions[v] - model->restPositions[v] - fall).norm(), 1e-12);
  }
}

TEST_P(ScalarMatrixSolver, survivesVerticesThatFallTogetherAndAClothHeldEverywhere) {
  const auto model = pinnedSheet(3);
  EXPECT_TRUE(isFinite(run(*model, {}, 3, stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5))))));
  const auto loose = unevenSheet(3, {});
  EXPECT_TRUE(isFinite(run(*loose, {}, 3, stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5))))));
  const auto pinned = withPins(*model, std::vector<bool>(9, true));
  StepInputs inputs;
  inputs.attachment = Attachment{{0, Vec3(1.0, 0.0, 0.0), Vec3(1.0, 1.0, 0.0)}, {500.0, 10.0}};
  ClothState state = stateAtRest(pinned->restPositions);
  make()->step(*pinned, {}, inputs, state);
  EXPECT_EQ(stateHash(state), stateHash(stateAtRest(pinned->restPositions)));
}

TEST_P(ScalarMatrixSolver, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = pinnedSheet(48);
  const auto hash = [&](int threads) {
    StepParameters p;
    p.threads = threads;
    p.air.drag = 0.5;
    p.material.damping = 0.01;
    p.air.wind = Vec3(2.0, 0.0, 1.0);
    return stateHash(run(*model, p, 5, shaken(*model, 0.002, 3)));
  };
  const auto alone = hash(1);
  EXPECT_EQ(alone, hash(2));
  EXPECT_EQ(alone, hash(3));
}

/// Half the distance of a pair that vibrates freely along its spring: l0/2 + A cos(omega t), omega^2 = 2 k / m.
TEST_P(ScalarMatrixSolver, vibratesAFreePairWithAnErrorOfFirstOrder) {
  const auto model = pair({});
  StepParameters p;
  p.gravity = 0.0;
  p.material.stiffness = 10.0;
  const double omega = std::sqrt(2.0 * p.material.stiffness / model->vertexMass[0]);
  const double amplitude = 0.1;
  const auto error = [&](int steps) {
    const double seconds = 0.25;
    p.timeStep = seconds / steps;
    const ClothState start = stateAtRest({Vec3(-amplitude, 0.0, 0.0), Vec3(1.0 + amplitude, 0.0, 0.0)});
    const ClothState end = run(*model, p, steps, start);
    return std::abs(end.positions[1].x() - (1.0 + amplitude * std::cos(omega * seconds)));
  };
  EXPECT_LT(error(2000), 0.05 * amplitude);
  EXPECT_NEAR(std::log2(error(2000) / error(4000)), 1.0, 0.1);
}

/// A stretched pair circles its middle for ever: m omega^2 L / 2 = k (L - l0).
TEST_P(ScalarMatrixSolver, circlesAFreePairWithAnErrorOfFirstOrder) {
  const auto model = pair({});
  StepParameters p;
  p.gravity = 0.0;
  p.material.stiffness = 10.0;
  const double length = 1.5;
  const double omega = std::sqrt(2.0 * p.material.stiffness * (length - 1.0) / (model->vertexMass[0] * length));
  const auto error = [&](int steps) {
    const double seconds = 0.1;
    p.timeStep = seconds / steps;
    ClothState start = stateAtRest({Vec3(-length / 2.0, 0.0, 0.0), Vec3(length / 2.0, 0.0, 0.0)});
    start.velocities = {Vec3(0.0, -omega * length / 2.0, 0.0), Vec3(0.0, omega * length / 2.0, 0.0)};
    const ClothState end = run(*model, p, steps, start);
    const Vec3 exact(std::cos(omega * seconds), std::sin(omega * seconds), 0.0);
    return (end.positions[1] - length / 2.0 * exact).norm();
  };
  EXPECT_NEAR(std::log2(error(4000) / error(8000)), 1.0, 0.1);
}

/// Stoermer-Verlet far below its limit, from the forces alone.
ClothState exactMotion(const ClothModel& model, double k, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds * 5000.0));
  const double h = seconds / steps;
  const Eigen::MatrixXd free = freedom(model);
  Rows x = rowsOf(model.restPositions);
  Rows v = Rows::Zero(x.rows(), 3);
  const auto acceleration = [&] {
    Rows a = springForces(model, k, x) / model.vertexMass[0];
    a.col(1).array() -= 9.81;
    return Rows(free.diagonal().asDiagonal() * a);
  };
  Rows a = acceleration();
  for (int step = 0; step < steps; ++step) {
    v += 0.5 * h * a;
    x += h * v;
    a = acceleration();
    v += 0.5 * h * a;
  }
  ClothState state = stateAtRest(model.restPositions);
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    state.positions[i] = x.row(i).transpose();
  }
  return state;
}

TEST_P(ScalarMatrixSolver, comesCloserToTheMotionOfAPinnedSheetWithShorterSteps) {
  const auto model = pinnedSheet(17);
  static const Rows exact = rowsOf(exactMotion(*model, 10.0, 0.2).positions);
  StepParameters p;
  p.material.stiffness = 10.0;
  double last = 1.0;
  for (const int steps : {120, 480, 1920}) {
    p.timeStep = 0.2 / steps;
    const ClothState state = run(*model, p, steps, stateAtRest(model->restPositions));
    const double error = (rowsOf(state.positions) - exact).rowwise().norm().mean();
    EXPECT_LT(error, 0.55 * last);
    last = error;
  }
  EXPECT_LT(last, 1e-3) << "[m], with steps of about 1e-4 s";
}

TEST_P(ScalarMatrixSolver, doesNotTakeEnergyFromNothingWhileAStrongAttachmentWavesTheCloth) {
  for (const std::vector<int>& pins : {std::vector<int>{0, 8}, std::vector<int>{}}) {
    for (const double h : {1.0 / 150.0, 1.0 / 30.0}) {
      const auto model = buildClothModel(sheet(9), 0.1, MassLumping::Uniform, pins);
      StepParameters p;
      p.timeStep = h;
      StepInputs inputs;
      inputs.attachment = Attachment{{40, Vec3(0.5, 0.3, 0.2), Vec3::Zero()}, {500.0, 10.0}};
      ClothState state = stateAtRest(model->restPositions);
      const auto solver = make();
      double fastest = 0.0;
      for (int step = 0; step * h < 4.0; ++step) {
        inputs.attachment->target = Vec3(0.5 + 0.3 * std::sin(6.0 * step * h), 0.5, 0.5);
        solver->step(*model, p, inputs, state);
        if (step * h > 2.0) {
          fastest = std::max(fastest, rowsOf(state.velocities).rowwise().norm().maxCoeff());
        }
      }
      EXPECT_LT(fastest, 20.0) << "[m/s]; the attachment moves at up to 1.8 m/s";
      EXPECT_LT((Vec3(state.positions[40]) - inputs.attachment->target).norm(), 0.6);
    }
  }
}

TEST_P(ScalarMatrixSolver, staysCalmWithStiffClothAtLargeSteps) {
  const auto model = pinnedSheet(17);
  StepParameters p;
  p.material.stiffness = 1e5;
  p.timeStep = 1.0 / 30.0;
  p.material.damping = 0.01;
  const auto solver = make();
  ClothState state = stateAtRest(model->restPositions);
  double highest = -1.0;
  for (int step = 0; step < 90; ++step) {
    solver->step(*model, p, {}, state);
    highest = std::max(highest, energyOf(*model, p, state).total());
  }
  // Two of them hang 1 cm too low at their pins (h^2 g), which is 62 J in springs of this stiffness.
  EXPECT_LT(highest, 70.0) << "[J]";
  EXPECT_LT(energyOf(*model, p, state).kinetic, 0.1) << "[J]";
}

double linearLoss(const char* solver) {
  const auto model = unevenSheet(9, {});
  ClothState state = shaken(*model, 0.03, 5);
  for (Vec3& velocity : state.velocities) {
    velocity += Vec3(1.0, 0.5, 0.2);
  }
  const Vec3 before = linearMomentum(*model, state);
  StepParameters p;
  p.gravity = 0.0;
  p.material.damping = 0.01;
  const auto method = findSolver(solver)->make();
  for (int step = 0; step < 100; ++step) {
    method->step(*model, p, {}, state);
  }
  return (linearMomentum(*model, state) - before).norm() / before.norm();
}

TEST(LocalGlobal, keepsTheLinearMomentumOfAFreeCloth) {
  EXPECT_LT(linearLoss("local_global"), 1e-10);
}

TEST(Kang, losesLinearMomentumOfAFreeCloth) {
  EXPECT_GT(linearLoss("kang"), 1e-4);
  EXPECT_LT(linearLoss("kang"), 0.2);
}

}  // namespace
}  // namespace drape::sim
