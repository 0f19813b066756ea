#include "reference_step.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/solvers/solver.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

namespace drape::sim {
namespace {

using testing::largestDifference;
using testing::pinnedSheet;
using testing::shaken;

ClothState after(const char* solver, const ClothModel& model, const StepParameters& parameters, ClothState state) {
  findSolver(solver)->make()->step(model, parameters, {}, state);
  return state;
}

TEST(Chebyshev, isTheOneIterationMethodWithOneIteration) {
  const auto model = pinnedSheet(5);
  const ClothState start = shaken(*model, 0.03, 7);
  StepParameters parameters;
  parameters.iteration.iterations = 1;
  EXPECT_LT(largestDifference(after("chebyshev", *model, parameters, start),
                              after("one_iteration", *model, parameters, start)),
            1e-14);
}

TEST(Chebyshev, isPlainJacobiForASpectralRadiusOfZero) {
  const auto model = pinnedSheet(5);
  const ClothState start = shaken(*model, 0.03, 7);
  StepParameters parameters;
  parameters.iteration.spectralRadius = 0.0;
  parameters.jacobi.sweeps = 5;
  for (const int iterations : {5, 6}) {  // of six the start counts as the first
    parameters.iteration.iterations = iterations;
    EXPECT_LT(largestDifference(after("chebyshev", *model, parameters, start),
                                after("one_iteration", *model, parameters, start)),
              1e-13);
  }
}

TEST(Chebyshev, convergesToTheExactSolveWithDampingAirAndAttachment) {
  for (const auto& model : {pinnedSheet(5), testing::irregularSheet(5, {})}) {
    StepParameters parameters;
    parameters.material.damping = 0.02;
    parameters.air.drag = 0.8;
    parameters.air.lift = 0.5;
    parameters.air.wind = Vec3(1.0, 0.2, -2.0);
    parameters.iteration.iterations = 200;
    parameters.iteration.spectralRadius = 0.9;
    StepInputs inputs;
    inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, 5.0}};
    ClothState state = shaken(*model, 0.03, 7);
    ClothState exact = state;
    findSolver("chebyshev")->make()->step(*model, parameters, inputs, state);
    exactLinearStep(*model, parameters, inputs, testing::AttachmentDerivative::Lumped, exact);
    EXPECT_LT(largestDifference(state, exact), 1e-9);
  }
}

TEST(Chebyshev, comesNearerToTheExactSolveThanAsManyPlainSweeps) {
  const auto model = pinnedSheet(9);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  parameters.iteration.spectralRadius = 0.95;
  parameters.iteration.iterations = 15;
  parameters.jacobi.sweeps = 15;
  const ClothState start = shaken(*model, 0.01, 7);
  ClothState exact = start;
  exactLinearStep(*model, parameters, {}, testing::AttachmentDerivative::Lumped, exact);
  const double accelerated = largestDifference(after("chebyshev", *model, parameters, start), exact);
  const double plain = largestDifference(after("one_iteration", *model, parameters, start), exact);
  EXPECT_LT(accelerated, 0.5 * plain);
}

double largestEnergy(const ClothModel& model, const StepParameters& parameters) {
  ClothState state = stateAtRest(model.restPositions);
  const auto solver = findSolver("chebyshev")->make();
  double largest = -std::numeric_limits<double>::infinity();
  for (int step = 0; step < 300; ++step) {
    solver->step(model, parameters, {}, state);
    largest = std::max(largest, energyOf(model, parameters, state).total());
  }
  return largest;
}

bool warnsOfOvershoot(const ClothModel& model, const StepParameters& parameters) {
  const auto warning = findSolver("chebyshev")->warning(model, parameters);
  return warning && warning->kind == SolverWarning::Kind::Overshoots;
}

TEST(Chebyshev, isCalmWithAnyNumberOfIterationsThatItDoesNotCallAnOvershoot) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  int calm = 0;
  for (const double radius : {0.0, 0.8, 0.95}) {
    for (const int iterations : {1, 4, 5, 6, 9, 10}) {
      parameters.iteration.spectralRadius = radius;
      parameters.iteration.iterations = iterations;
      if (!warnsOfOvershoot(*model, parameters)) {
        EXPECT_LT(largestEnergy(*model, parameters), 1.0) << iterations << " iterations, radius " << radius;
        ++calm;
      }
    }
  }
  EXPECT_EQ(calm, 18) << "none of these overshoots";
}

TEST(Chebyshev, warnsWhereItsIterationsOvershoot) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  parameters.iteration.spectralRadius = 0.99;
  for (const int iterations : {5, 6}) {
    parameters.iteration.iterations = iterations;
    EXPECT_TRUE(warnsOfOvershoot(*model, parameters));
    EXPECT_GT(largestEnergy(*model, parameters), 10.0) << iterations;
  }
  parameters.substeps = 100;
  EXPECT_FALSE(findSolver("chebyshev")->warning(*model, parameters));
}

TEST(Chebyshev, saysThatClothIsSlackWhereIterationsAreTooFew) {
  const auto model = pinnedSheet(17);
  StepParameters parameters;
  parameters.material.stiffness = 1000.0;
  EXPECT_EQ(findSolver("chebyshev")->warning(*model, parameters).value().kind,
            SolverWarning::Kind::AcceleratedTooLittle);
  parameters.material.stiffness = 10.0;
  EXPECT_FALSE(findSolver("chebyshev")->warning(*model, parameters));
}

}  // namespace
}  // namespace drape::sim
