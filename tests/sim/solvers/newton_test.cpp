#include "reference_step.hpp"
#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <stop_token>

namespace drape::sim {
namespace {

using testing::largestDifference;
using testing::pinnedSheet;
using testing::shaken;

/// What x and v leave over of M (v - v0) = h f(x, v) at the free vertices [N s], where v0 are the velocities of `from`.
/// Springs, damping and gravity only; written from the equations.
double leftOver(const ClothModel& model, const StepParameters& p, const ClothState& from, const std::vector<Vec3>& x,
                const std::vector<Vec3>& v) {
  std::vector<Vec3> rest;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 weight(0.0, -p.gravity * model.vertexMass[i], 0.0);
    rest.emplace_back(model.vertexMass[i] * (v[i] - from.velocities[i]) - p.timeStep * weight);
  }
  for (const Spring& spring : model.springs) {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const double L = (x[b] - x[a]).norm();
    const Vec3 pull =
        p.material.stiffness * (1.0 - spring.restLength / L) * (x[b] - x[a]) + p.material.damping * (v[b] - v[a]);
    rest[a] -= p.timeStep * pull;
    rest[b] += p.timeStep * pull;
  }
  double square = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    square += model.pinned[i] ? 0.0 : rest[i].squaredNorm();
  }
  return std::sqrt(square);
}

/// What is left over where nothing moves, against which the solver measures.
double leftOverAtFirst(const ClothModel& model, const StepParameters& p, const ClothState& from) {
  return leftOver(model, p, from, from.positions, std::vector<Vec3>(from.velocities.size(), Vec3::Zero()));
}

TEST(Newton, isTheDenseSolveOfTheLinearisedStepWithOneIteration) {
  const auto solver = findSolver("newton")->make();
  StepParameters parameters;
  parameters.iteration.maxIterations = 1;
  parameters.material.damping = 0.02;
  parameters.air.drag = 0.8;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.2, -2.0);
  for (const auto& model : {pinnedSheet(5), testing::irregularSheet(5), testing::irregularSheet(5, {})}) {
    for (const double maxForce : {50.0, 2.0}) {
      StepInputs inputs;
      inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, maxForce}};
      ClothState state = shaken(*model, 0.03, 7);
      ClothState exact = state;
      EXPECT_EQ(solver->step(*model, parameters, inputs, state).iterations, 1);
      exactLinearStep(*model, parameters, inputs, testing::AttachmentDerivative::Whole, exact);
      EXPECT_LT(largestDifference(state, exact), 1e-10);
    }
  }
}

/// Of cloth so stiff that Newton's method has to work for it.
StepParameters stiffParameters() {
  StepParameters parameters;
  parameters.material.stiffness = 1e5;
  parameters.timeStep = 1.0 / 30.0;
  return parameters;
}

TEST(Newton, solvesTheEquationsOfAStiffShakenClothToItsTolerance) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = stiffParameters();
  parameters.material.damping = 0.01;
  parameters.iteration.tolerance = 1e-10;
  ClothState state = shaken(*model, 0.03, 7);
  const auto solver = findSolver("newton")->make();
  for (int step = 0; step < 3; ++step) {
    const ClothState before = state;
    const StepReport report = solver->step(*model, parameters, {}, state);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.residual, 1e-10);
    // The residual uses lengths from positions near 1 m, which are accurate to 1e-16 m.
    const double rounding = parameters.timeStep * parameters.material.stiffness * 2.2e-16 *
                            std::sqrt(6.0 * static_cast<double>(model->springs.size()));
    EXPECT_LT(leftOver(*model, parameters, before, state.positions, state.velocities),
              1e-10 * leftOverAtFirst(*model, parameters, before) + rounding)
        << "step " << step;
  }
}

TEST(Newton, reportsThatItDidNotConverge) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = stiffParameters();
  parameters.iteration.tolerance = 1e-10;
  parameters.iteration.maxIterations = 3;
  ClothState state = shaken(*model, 0.03, 7);
  const ClothState before = state;
  const StepReport report = findSolver("newton")->make()->step(*model, parameters, {}, state);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3);
  const double expected = leftOver(*model, parameters, before, state.positions, state.velocities) /
                          leftOverAtFirst(*model, parameters, before);
  EXPECT_NEAR(report.residual, expected, 1e-9 * expected);
}

TEST(Newton, stopsBetweenItsIterationsWhenAStopIsRequested) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = stiffParameters();
  parameters.iteration.tolerance = 1e-10;
  int calls = 0;
  std::stop_source source;
  const std::function<void()> onProgress = [&] {
    if (++calls == 3) {
      source.request_stop();
    }
  };
  StepInputs inputs;
  inputs.stop = source.get_token();
  inputs.onProgress = &onProgress;
  ClothState state = shaken(*model, 0.03, 7);
  const auto before = stateHash(state);
  EXPECT_THROW(findSolver("newton")->make()->step(*model, parameters, inputs, state), StepStopped);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(stateHash(state), before);
}

TEST(Newton, stopsAtRoundingForASmallerTolerance) {
  const auto model = pinnedSheet(9);
  StepParameters parameters = stiffParameters();
  parameters.iteration.tolerance = 1e-30;
  ClothState state = stateAtRest(model->restPositions);
  const auto solver = findSolver("newton")->make();
  for (int step = 0; step < 10; ++step) {
    const StepReport report = solver->step(*model, parameters, {}, state);
    EXPECT_TRUE(report.converged) << "step " << step;
    EXPECT_LT(report.residual, 1e-9) << "step " << step;
  }
}

TEST(Newton, endsInTheSamePlaceForEveryVariantOfTheForceDerivative) {
  const auto model = pinnedSheet(9);
  StepParameters parameters;
  parameters.material.stiffness = 100.0;
  parameters.iteration.tolerance = 1e-10;
  parameters.iteration.maxIterations = 2000;
  const auto end = [&](ForceDerivative variant) {
    ClothState state = shaken(*model, 0.03, 7);
    parameters.derivative = variant;
    EXPECT_TRUE(findSolver("newton")->make()->step(*model, parameters, {}, state).converged);
    return state;
  };
  const ClothState exact = end(ForceDerivative::Exact);
  for (const auto variant : testing::allDerivatives) {
    EXPECT_LT(largestDifference(end(variant), exact), 1e-6) << static_cast<int>(variant);
  }
}

TEST(Newton, takesFewestIterationsWithTheExactDerivative) {
  const auto model = pinnedSheet(9);
  StepParameters parameters;
  parameters.iteration.tolerance = 1e-8;
  const auto iterations = [&](ForceDerivative variant) {
    ClothState state = shaken(*model, 0.02, 7);
    parameters.derivative = variant;
    return findSolver("newton")->make()->step(*model, parameters, {}, state).iterations;
  };
  const int exact = iterations(ForceDerivative::Exact);
  EXPECT_LE(exact, 10);
  EXPECT_GT(iterations(ForceDerivative::Stabilised), exact);
  EXPECT_GT(iterations(ForceDerivative::Scalar), iterations(ForceDerivative::Stabilised));
}

TEST(Newton, settlesAnAttachedPointWhereMouseSpringAndWeightBalance) {
  const auto model = testing::irregularSheet(3, {});
  ClothState state = stateAtRest(model->restPositions);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  parameters.material.damping = 0.5;
  parameters.timeStep = 1.0 / 30.0;
  StepInputs inputs;
  inputs.attachment = Attachment{{0, Vec3(0.2, 0.3, 0.5), Vec3(0.4, 0.5, 0.4)}, {40.0, 100.0}};
  const auto solver = findSolver("newton")->make();
  for (int step = 0; step < 600; ++step) {
    EXPECT_TRUE(solver->step(*model, parameters, inputs, state).converged);
  }
  Vec3 point = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    point += inputs.attachment->barycentric[static_cast<Eigen::Index>(c)] * state.positions[model->triangles[0][c]];
  }
  const double below = 0.1 * parameters.gravity / inputs.attachment->stiffness;
  EXPECT_LT((point - inputs.attachment->target + Vec3(0.0, below, 0.0)).norm(), 1e-3);
}

}  // namespace
}  // namespace drape::sim
