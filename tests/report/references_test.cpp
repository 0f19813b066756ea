#include "report/references.hpp"

#include "messages/error.hpp"
#include "report/sections/set_ups.hpp"
#include "sim/measures/measures.hpp"
#include "sim/solvers/solver.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>

namespace drape::report {
namespace {

constexpr int checkpoints = 3;

/// A converged reference by a first-order method, which needs many halvings.
Reference firstOrder(const scene::Scene& scene, const ConvergenceTolerance& tolerance) {
  return convergedReference(scene, testing::with(scene, {"solver=one_iteration", "sweeps=3"}), checkpoints, tolerance);
}

TEST(ConvergedReference, halvesUntilTheDifferenceIsBelowTheToleranceAndIsThatNearToAFarFinerRun) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  ConvergenceTolerance tolerance;
  tolerance.absolute = 2e-5;
  const Reference reference = firstOrder(*scene, tolerance);
  EXPECT_EQ(reference.doubt, "");
  EXPECT_EQ(reference.trusted, checkpoints);
  ASSERT_GE(reference.halvings.size(), 3U);
  const Halving& last = reference.halvings.back();
  EXPECT_LE(last.difference, 2e-5);
  EXPECT_GT(reference.halvings[reference.halvings.size() - 2].difference, 2e-5);
  EXPECT_DOUBLE_EQ(last.timeStep, reference.settings.step.timeStep);

  settings::Settings finer = reference.settings;
  finer.step.timeStep /= 16.0;
  const Trajectory truth = runTrajectory(*scene, finer, checkpoints);
  const double distance =
      sim::meanDistance(truth.states.back().positions, reference.trajectory.states.back().positions);
  EXPECT_GT(distance, 0.5 * last.difference);  // of first order: the remaining error is as large
  EXPECT_LT(distance, 1.1 * last.difference);
}

TEST(ConvergedReference, takesAnInaccurateReferenceOnlyOnRequest) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  ConvergenceTolerance tolerance;
  tolerance.absolute = 1e-12;
  tolerance.maxHalvings = 1;
  EXPECT_THROW(firstOrder(*scene, tolerance), messages::InputError);
  tolerance.takeAnyway = true;
  const Reference reference = firstOrder(*scene, tolerance);
  EXPECT_EQ(reference.trusted, 0);
  EXPECT_EQ(reference.trajectory.checkpoints(), checkpoints);
  EXPECT_GT(reference.differences.back(), tolerance.absolute);
}

TEST(ConvergedReference, saysWhereItEndsWhenItIsNotConverged) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  ConvergenceTolerance exact;
  exact.absolute = 1e-12;
  exact.maxHalvings = 3;
  const Reference three = [&] {
    ConvergenceTolerance tolerance = exact;
    tolerance.absolute = 1.0;
    return firstOrder(*scene, tolerance);
  }();
  ASSERT_EQ(three.differences.size(), 4U);
  // A tolerance between the remaining differences of the first and the last checkpoint, after three halvings.
  ConvergenceTolerance tolerance = exact;
  tolerance.maxHalvings = 1;
  tolerance.absolute = 0.5 * (three.differences[1] + three.differences[3]);
  const Reference reference = firstOrder(*scene, tolerance);
  EXPECT_GE(reference.trusted, 1);
  EXPECT_LT(reference.trusted, checkpoints);
  EXPECT_NE(reference.doubt.find("does not converge after"), std::string::npos) << reference.doubt;
  EXPECT_NE(reference.doubt.find("would take too long"), std::string::npos) << reference.doubt;
  EXPECT_THROW((void)firstOrder(*scene, exact), messages::InputError);
}

TEST(ConvergedReference, convergesInTheDampingOfAFabricToo) {
  // The damping acts once in a step. Substeps of longer steps would leave its error as it is.
  const auto scene = testing::smallGrid(
      {"material.model=fabric", "material.preset=jersey", "fabric.bend_damping=0.1", "fabric.stretch_damping=0.05"});
  ConvergenceTolerance tolerance;
  tolerance.absolute = 1e-6;
  const Reference reference = convergedReference(*scene, convergedSettings(scene->settings), checkpoints, tolerance);
  ASSERT_EQ(reference.doubt, "");
  settings::Settings finer = reference.settings;
  finer.step.timeStep /= 4.0;
  const Trajectory truth = runTrajectory(*scene, finer, checkpoints);
  EXPECT_LT(sim::meanDistance(truth.states.back().positions, reference.trajectory.states.back().positions), 1e-6);
}

TEST(ConvergedReference, needsBeNoBetterThanTheErrorThatItJudges) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  const Trajectory compared = runTrajectory(*scene, scene->settings, checkpoints);
  ConvergenceTolerance tolerance;
  tolerance.absolute = 1e-12;
  tolerance.share = 0.02;
  tolerance.compared = &compared;
  const Reference reference = firstOrder(*scene, tolerance);
  EXPECT_EQ(reference.doubt, "");
  for (std::size_t k = 1; k <= checkpoints; ++k) {
    const double error = sim::meanDistance(compared.states[k].positions, reference.trajectory.states[k].positions);
    EXPECT_LE(reference.differences[k], 0.02 * error);
    EXPECT_GT(reference.differences[k], 1e-12);
  }
}

TEST(ConvergedReference, doesNotBeginARunThatIsTooLong) {
  const auto scene = testing::smallGrid();
  ConvergenceTolerance tolerance;
  tolerance.absolute = 1e-12;
  tolerance.maxCost = 1.0;
  try {
    (void)firstOrder(*scene, tolerance);
    FAIL() << "it is too long";
  } catch (const messages::InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("would take too long"), std::string::npos) << text;
    EXPECT_NE(text.find("--seconds"), std::string::npos) << text;
    EXPECT_EQ(text.find("still moved"), std::string::npos) << "no halving has taken place: " << text;
  }
}

TEST(ConvergedReference, ofVerletApproachesTheLimitWithTheSquareOfItsStep) {
  const auto scene = testing::smallGrid({"stiffness=10"});
  ConvergenceTolerance tolerance;
  tolerance.absolute = 1e-8;
  const Reference reference = convergedReference(*scene, convergedSettings(scene->settings), checkpoints, tolerance);
  EXPECT_EQ(reference.doubt, "");
  EXPECT_EQ(reference.settings.solver.name, "verlet");
  const std::size_t last = reference.halvings.size() - 1;
  ASSERT_GE(last, 2U);
  EXPECT_NEAR(reference.halvings[last - 2].difference / reference.halvings[last].difference, 16.0, 0.5);

  // A very different second-order method converges to the same motion.
  const settings::Settings midpoint =
      testing::with(*scene, {"solver=newton", "integration=theta", "theta=0.5", "time_step=1/3000", "tolerance=1e-12"});
  const Trajectory truth = runTrajectory(*scene, midpoint, checkpoints);
  EXPECT_LT(sim::meanDistance(truth.states.back().positions, reference.trajectory.states.back().positions), 5e-6);
}

TEST(ConvergedReference, isInDoubleWhateverThePrecisionOfTheMethod) {
  for (const char* precision : {"float", "double"}) {
    const auto scene = testing::smallGrid({std::string("precision=") + precision});
    EXPECT_EQ(convergedSettings(scene->settings).step.precision, sim::Precision::Double) << precision;
  }
}

TEST(ConvergedReference, beginsBelowHalfOfTheStabilityLimit) {
  const auto scene = testing::smallGrid({"stiffness=1e5"});
  ConvergenceTolerance loose;
  loose.absolute = 1.0;
  const Reference reference = convergedReference(*scene, convergedSettings(scene->settings), checkpoints, loose);
  ASSERT_EQ(reference.halvings.size(), 1U);
  EXPECT_TRUE(reference.trajectory.finite);
  const double limit = sim::findSolver("verlet")->stepLimit(*scene->model, scene->settings.step);
  EXPECT_LE(2.0 * reference.settings.step.timeStep, 0.5 * limit * (1.0 + 1e-9));
}

TEST(ConvergedReference, givesUpWhereHalvingBringsItNoNearer) {
  // A compressed stiff sheet buckles in ways that depend on rounding errors.
  const auto scene =
      sections::buildSetUp(sections::comparedSetUps("crush").at(0), 9, {"stiffness=1e5", "precision=double"});
  ConvergenceTolerance tight;
  tight.absolute = 1e-9;
  try {
    (void)convergedReference(*scene, convergedSettings(scene->settings), checkpoints, tight);
    FAIL() << "there should be no reference";
  } catch (const messages::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("do not reduce this"), std::string::npos) << error.what();
  }
}

TEST(SameStepReference, solvesEachStepToTheEnd) {
  const auto scene = testing::smallGrid({"stiffness=1000"});
  const Reference reference = sameStepReference(*scene, sameStepSettings(scene->settings), checkpoints);
  EXPECT_EQ(reference.doubt, "");
  EXPECT_GT(reference.trajectory.largestStepResidual, 0.0);
  EXPECT_LT(reference.trajectory.largestStepResidual, 1e-8);
}

TEST(SameStepReference, saysWhenAStepWasNotSolved) {
  const auto scene = testing::smallGrid({"stiffness=1000"});
  settings::Settings settings = sameStepSettings(scene->settings);
  settings.step.iteration.maxIterations = 1;
  const Reference reference = sameStepReference(*scene, settings, checkpoints);
  EXPECT_GT(reference.trajectory.unsolvedSteps, 0);
  EXPECT_NE(reference.doubt.find("did not reach its tolerance"), std::string::npos) << reference.doubt;
}

TEST(References, areDifferentMotionsAtALargeStep) {
  const auto scene = testing::smallGrid({"stiffness=10", "time_step=1/30"});
  const Reference same = sameStepReference(*scene, sameStepSettings(scene->settings), checkpoints);
  const Reference converged = convergedReference(*scene, convergedSettings(scene->settings), checkpoints, {});
  EXPECT_GT(sim::meanDistance(same.trajectory.states.back().positions, converged.trajectory.states.back().positions),
            0.01);
}

TEST(SameStepReference, keepsTheMethodsStep) {
  const auto scene = testing::smallGrid({"time_step=1/300", "substeps=2", "integration=theta", "theta=0.75"});
  const settings::Settings settings = sameStepSettings(scene->settings);
  EXPECT_EQ(settings.solver.name, "newton");
  EXPECT_EQ(settings.step.iteration.tolerance, 1e-10);
  EXPECT_EQ(settings.step.timeStep, scene->settings.step.timeStep);
  EXPECT_EQ(settings.step.substeps, 2);
  EXPECT_EQ(settings.step.integration, sim::Integration::Theta);
}

TEST(SolverReference, isThatSolversRun) {
  const auto scene = testing::smallGrid();
  const Reference reference = solverReference(*scene, scene->settings, checkpoints);
  const Trajectory run = runTrajectory(*scene, scene->settings, checkpoints);
  EXPECT_EQ(sim::stateHash(reference.trajectory.states.back()), sim::stateHash(run.states.back()));
  EXPECT_EQ(reference.trusted, checkpoints);
}

}  // namespace
}  // namespace drape::report
