#include "reference_step.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using testing::largestDifference;
using testing::pinnedSheet;
using testing::shaken;

StepParameters withEverything() {
  StepParameters parameters;
  parameters.material.damping = 0.02;
  parameters.air.drag = 0.8;
  parameters.air.lift = 0.5;
  parameters.air.wind = Vec3(1.0, 0.2, -2.0);
  parameters.iteration.tolerance = 1e-12;
  return parameters;
}

StepInputs attachmentWith(double maxForce) {
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, maxForce}};
  return inputs;
}

TEST(Pcg, equalsTheDenseSolveWithDampingAirAndAttachmentWithPinsAndWithout) {
  const auto solver = findSolver("pcg")->make();
  for (const auto& model : {pinnedSheet(5), testing::irregularSheet(5), testing::irregularSheet(5, {})}) {
    for (const double maxForce : {50.0, 0.05}) {
      ClothState state = shaken(*model, 0.03, 7);
      ClothState exact = state;
      for (int step = 0; step < 5; ++step) {
        EXPECT_TRUE(solver->step(*model, withEverything(), attachmentWith(maxForce), state).converged);
        exactLinearStep(*model, withEverything(), attachmentWith(maxForce), testing::AttachmentDerivative::Lumped,
                        exact);
        EXPECT_LT(largestDifference(state, exact), 1e-9);
      }
    }
  }
}

TEST(Pcg, equalsTheDenseSolveInEveryVariantOfTheForceDerivativeThatIsSemiDefinite) {
  const auto model = pinnedSheet(5);
  for (const auto variant : testing::allDerivatives) {
    if (variant == ForceDerivative::Exact) {
      continue;
    }
    StepParameters parameters = withEverything();
    parameters.derivative = variant;
    parameters.material.stiffness = 1000.0;
    ClothState state = shaken(*model, 0.03, 7);
    ClothState exact = state;
    const StepReport report = findSolver("pcg")->make()->step(*model, parameters, {}, state);
    exactLinearStep(*model, parameters, {}, testing::AttachmentDerivative::Lumped, exact);
    EXPECT_TRUE(report.converged);
    EXPECT_LT(largestDifference(state, exact), 1e-8) << static_cast<int>(variant);
  }
}

TEST(Pcg, equalsTheDenseSolveWithTheExactDerivativeWhereTheMatrixIsDefinite) {
  const auto model = pinnedSheet(5);
  StepParameters parameters = withEverything();
  parameters.derivative = ForceDerivative::Exact;
  ClothState state = shaken(*model, 0.01, 7);
  ClothState exact = state;
  EXPECT_TRUE(findSolver("pcg")->make()->step(*model, parameters, {}, state).converged);
  exactLinearStep(*model, parameters, {}, testing::AttachmentDerivative::Lumped, exact);
  EXPECT_LT(largestDifference(state, exact), 1e-9);
}

TEST(Pcg, stopsAtNegativeCurvatureAndSaysSo) {
  const auto model = pinnedSheet(9);
  StepParameters parameters;
  parameters.derivative = ForceDerivative::Exact;
  parameters.material.stiffness = 1e5;
  parameters.timeStep = 1.0 / 30.0;
  ClothState state = stateAtRest(model->restPositions);
  for (Vec3& position : state.positions) {
    position *= 0.7;  // every spring is compressed
  }
  const auto solver = findSolver("pcg")->make();
  for (int step = 0; step < 20; ++step) {
    const StepReport report = solver->step(*model, parameters, {}, state);
    EXPECT_TRUE(std::isfinite(report.residual));
    if (step == 0) {
      EXPECT_FALSE(report.converged);
    }
    ASSERT_TRUE(isFinite(state)) << "step " << step;
  }
}

TEST(Pcg, endsAtItsToleranceOrItsMostIterationsAndReportsWhich) {
  const auto model = pinnedSheet(9);
  StepParameters parameters;
  parameters.material.stiffness = 1e4;
  parameters.iteration.tolerance = 1e-4;
  ClothState state = shaken(*model, 0.01, 7);
  const ClothState start = state;
  const StepReport reached = findSolver("pcg")->make()->step(*model, parameters, {}, state);
  EXPECT_TRUE(reached.converged);
  EXPECT_LE(reached.residual, 1e-4);
  EXPECT_GT(reached.iterations, 3);
  parameters.iteration.maxIterations = 3;
  state = start;
  const StepReport stopped = findSolver("pcg")->make()->step(*model, parameters, {}, state);
  EXPECT_FALSE(stopped.converged);
  EXPECT_GT(stopped.residual, 1e-4);
  EXPECT_EQ(stopped.iterations, 3);
}

TEST(Pcg, comesNearerToTheExactSolveTheSmallerTheTolerance) {
  const auto model = pinnedSheet(5);
  StepParameters parameters;
  parameters.material.stiffness = 1e4;
  ClothState exact = shaken(*model, 0.03, 7);
  const ClothState start = exact;
  exactLinearStep(*model, parameters, {}, testing::AttachmentDerivative::Lumped, exact);
  double last = 1e3;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    parameters.iteration.tolerance = tolerance;
    ClothState state = start;
    findSolver("pcg")->make()->step(*model, parameters, {}, state);
    const double difference = largestDifference(state, exact);
    EXPECT_LT(difference, 0.2 * last) << tolerance;
    last = difference;
  }
}

}  // namespace
}  // namespace drape::sim
