#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <string>

/// Properties of every solver of a backward-Euler step.
namespace drape::sim {
namespace {

using testing::irregularSheet;
using testing::pinnedSheet;
using testing::shaken;

class ImplicitSolver : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] static std::unique_ptr<Solver> make() { return findSolver(GetParam())->make(); }

  static void run(const ClothModel& model, const StepParameters& parameters, int steps, ClothState& state) {
    const auto solver = make();
    for (int step = 0; step < steps; ++step) {
      solver->step(model, parameters, {}, state);
    }
  }
};

class ConvergingSolver : public ImplicitSolver {};

TEST_P(ConvergingSolver, makesFreeClothFallByBackwardEulersClosedForm) {
  const auto model = irregularSheet(4, {});
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.material.damping = 0.1;
  parameters.iteration.tolerance = 1e-12;
  const int steps = 30;
  run(*model, parameters, steps, state);
  const double h = parameters.timeStep;
  const double fall = -0.5 * parameters.gravity * h * h * steps * (steps + 1);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - model->restPositions[v] - Vec3(0.0, fall, 0.0)).norm(), 1e-11);
  }
  EXPECT_NEAR(state.time, steps * h, 1e-12);
}

TEST_P(ImplicitSolver, movesVerticesFreelyWhereThereIsNoStiffness) {
  const auto model = irregularSheet(4, {2});
  ClothState state = shaken(*model, 0.02, 5);
  const ClothState start = state;
  StepParameters parameters;
  parameters.material.stiffness = 0.0;
  parameters.iteration.tolerance = 1e-12;
  parameters.iteration.iterations =
      9;  // an even number of Chebyshev iterations is made for stiff modes and not exact here
  run(*model, parameters, 1, state);
  const double h = parameters.timeStep;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3 velocity = v == 2 ? Vec3(Vec3::Zero()) : Vec3(start.velocities[v] - Vec3(0.0, 9.81 * h, 0.0));
    EXPECT_LT((state.velocities[v] - velocity).norm(), 1e-12);
    EXPECT_LT((state.positions[v] - start.positions[v] - h * velocity).norm(), 1e-12);
  }
}

TEST_P(ImplicitSolver, leavesAClothAtRestWithoutForcesWhereItIs) {
  const auto model = irregularSheet(6);
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air.drag = 1.0;
  parameters.air.lift = 1.0;
  parameters.material.stiffness = 1e5;
  run(*model, parameters, 100, state);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    EXPECT_LT((state.positions[v] - model->restPositions[v]).norm(), 1e-13);
    EXPECT_LT(state.velocities[v].norm(), 1e-12);
  }
}

TEST_P(ImplicitSolver, keepsPinnedVerticesWhereTheyAre) {
  const auto model = pinnedSheet(6);
  ClothState state = stateAtRest(model->restPositions);
  run(*model, {}, 100, state);
  for (const std::size_t pin : {0U, 5U}) {
    EXPECT_EQ(state.positions[pin], model->restPositions[pin]);
    EXPECT_EQ(state.velocities[pin], Vec3(Vec3::Zero()));
  }
  EXPECT_LT(state.positions[35].y(), -0.3) << "the free end should have fallen";
}

TEST_P(ImplicitSolver, movesNothingWhereEverythingIsPinned) {
  const auto model = irregularSheet(2, {0, 1, 2, 3});
  ClothState state = stateAtRest(model->restPositions);
  run(*model, {}, 3, state);
  EXPECT_EQ(state.positions, model->restPositions);
}

TEST_P(ImplicitSolver, takesTheModelOfEachStepAndNotThatOfTheLastOne) {
  const auto solver = make();
  StepParameters parameters;
  const auto other = irregularSheet(4, {1});
  ClothState elsewhere = shaken(*other, 0.02, 5);
  solver->step(*other, parameters, {}, elsewhere);
  const auto model = withPins(*other, std::vector<bool>(16, false));
  ClothState used = shaken(*model, 0.02, 6);
  ClothState fresh = used;
  solver->step(*model, parameters, {}, used);
  make()->step(*model, parameters, {}, fresh);
  EXPECT_EQ(stateHash(used), stateHash(fresh));
}

TEST_P(ImplicitSolver, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = pinnedSheet(47);  // more than 2048 vertices, so that loops over them are shared
  const auto hash = [&](int threads) {
    ClothState state = shaken(*model, 0.001, 3);
    StepParameters parameters;
    parameters.threads = threads;
    parameters.air.drag = 0.5;
    parameters.air.lift = 0.5;
    parameters.material.damping = 0.01;
    parameters.air.wind = Vec3(2.0, 0.0, 1.0);
    parameters.iteration.maxIterations = 3;
    run(*model, parameters, 2, state);
    return stateHash(state);
  };
  const auto one = hash(1);
  EXPECT_EQ(one, hash(2));
  EXPECT_EQ(one, hash(5));
}

TEST_P(ImplicitSolver, survivesVerticesThatFallTogether) {
  const auto model = pinnedSheet(3);
  ClothState state = stateAtRest(std::vector<Vec3>(9, Vec3(0.5, 0.0, 0.5)));
  run(*model, {}, 3, state);
  EXPECT_TRUE(isFinite(state));
}

TEST_P(ImplicitSolver, survivesSpringsWithoutRestLength) {
  ClothMesh mesh = testing::sheet(4);
  mesh.positions[5] = mesh.positions[6];
  const auto model = buildClothModel(mesh, 0.1, MassLumping::Area, {0});
  ClothState state = shaken(*model, 0.01, 4);
  run(*model, {}, 20, state);
  EXPECT_TRUE(isFinite(state));
}

INSTANTIATE_TEST_SUITE_P(All, ImplicitSolver, ::testing::Values("one_iteration", "chebyshev", "pcg", "newton"),
                         [](const auto& chosen) { return std::string(chosen.param); });

INSTANTIATE_TEST_SUITE_P(All, ConvergingSolver, ::testing::Values("pcg", "newton"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace drape::sim
