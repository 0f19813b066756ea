#include "sim/solvers/one_iteration_limits.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace drape::sim {
namespace {

using testing::pinnedSheet;

StepParameters with(double stiffness, double timeStep, int sweeps = 1) {
  StepParameters parameters;
  parameters.material.stiffness = stiffness;
  parameters.timeStep = timeStep;
  parameters.jacobi.sweeps = sweeps;
  return parameters;
}

std::optional<SolverWarning> warningOf(int n, const StepParameters& parameters) {
  return findSolver("one_iteration")->warning(*pinnedSheet(n), parameters);
}

/// The largest total energy within 2 s [J]; the sheet starts with none, and weighs 1 N.
double largestEnergy(int n, const StepParameters& parameters) {
  const auto model = pinnedSheet(n);
  ClothState state = stateAtRest(model->restPositions);
  Stepper stepper("one_iteration");
  double largest = 0.0;
  for (int step = 0; step * parameters.timeStep < 2.0; ++step) {
    stepper.step(*model, parameters, {}, state);
    const double energy = energyOf(*model, parameters, state).total();
    largest = std::isfinite(energy) ? std::max(largest, energy) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

bool saysThatEnergyComesFromNothing(int n, const StepParameters& parameters) {
  const auto warning = warningOf(n, parameters);
  return warning && warning->kind == SolverWarning::Kind::FlatClothGains;
}

TEST(OneIterationWarning, saysThatEnergyComesFromNothingWhereItDoes) {
  for (const auto& [n, parameters] : {std::pair(17, with(1e3, 1.0 / 30.0)), std::pair(17, with(1e5, 1.0 / 60.0)),
                                      std::pair(33, with(100.0, 1.0 / 30.0)), std::pair(33, with(1e3, 1.0 / 60.0)),
                                      std::pair(33, with(1e5, 1.0 / 150.0)), std::pair(65, with(1e3, 1.0 / 150.0)),
                                      std::pair(33, with(1e3, 1.0 / 30.0, 3))}) {
    EXPECT_TRUE(saysThatEnergyComesFromNothing(n, parameters)) << n << ", " << parameters.material.stiffness;
    EXPECT_GT(largestEnergy(n, parameters), 50.0) << n << ", " << parameters.material.stiffness;
  }
}

TEST(OneIterationWarning, doesNotSaySoWhereLittleEnergyComesFromNothing) {
  for (const auto& [n, parameters] : {std::pair(9, with(1e3, 1.0 / 60.0)), std::pair(17, with(10.0, 1.0 / 30.0)),
                                      std::pair(17, with(1e4, 1.0 / 150.0)), std::pair(33, with(1e3, 1.0 / 150.0)),
                                      std::pair(33, with(1e4, 1.0 / 600.0)), std::pair(65, with(10.0, 1.0 / 150.0)),
                                      std::pair(17, with(1e3, 1.0 / 60.0, 3))}) {
    EXPECT_FALSE(saysThatEnergyComesFromNothing(n, parameters)) << n << ", " << parameters.material.stiffness;
    EXPECT_LT(largestEnergy(n, parameters), 20.0) << n << ", " << parameters.material.stiffness;
  }
}

TEST(OneIterationWarning, namesSubstepsThatSatisfyItAndTakeTheEnergyAway) {
  StepParameters parameters = with(1e3, 1.0 / 30.0);
  EXPECT_EQ(warningOf(33, parameters).value().kind, SolverWarning::Kind::FlatClothGains);
  EXPECT_EQ(warningOf(33, parameters)->substeps, 4.0);
  parameters.substeps = 4;
  EXPECT_FALSE(saysThatEnergyComesFromNothing(33, parameters));
  EXPECT_LT(largestEnergy(33, parameters), 50.0) << "instead of 8e5 J";
}

/// Mean distance from the motion of small steps after 7/15 s [m].
double meanError(const char* solver, const StepParameters& parameters) {
  const auto model = pinnedSheet(17);
  const auto after = [&](const char* name, StepParameters p) {
    ClothState state = stateAtRest(model->restPositions);
    Stepper stepper(name);
    const auto steps = std::lround(7.0 / 15.0 / p.timeStep);
    for (int step = 0; step < steps; ++step) {
      stepper.step(*model, p, {}, state);
    }
    return state.positions;
  };
  StepParameters fine = parameters;
  fine.timeStep = 1.0 / 15000.0;
  const std::vector<Vec3> exact = after("verlet", fine);
  const std::vector<Vec3> approximate = after(solver, parameters);
  double sum = 0.0;
  for (std::size_t v = 0; v < exact.size(); ++v) {
    sum += (approximate[v] - exact[v]).norm() / static_cast<double>(exact.size());
  }
  return sum;
}

TEST(OneIterationWarning, saysThatClothIsSlackWhereItIsFarWorseThanTheExactSolve) {
  const StepParameters slack = with(10.0, 1.0 / 150.0);  // (h omega)^2 = 10
  EXPECT_EQ(warningOf(17, slack).value().kind, SolverWarning::Kind::TooFewSweeps);
  EXPECT_EQ(warningOf(17, slack)->iterations, 1);
  EXPECT_EQ(warningOf(17, slack)->substeps, 4.0);
  EXPECT_GT(meanError("one_iteration", slack), 10.0 * meanError("pcg", slack));
  const StepParameters fine = with(10.0, 1.0 / 600.0);  // 0.64
  EXPECT_FALSE(warningOf(17, fine));
  EXPECT_LT(meanError("one_iteration", fine), 3.0 * meanError("pcg", fine));
  const StepParameters swept = with(10.0, 1.0 / 150.0, 11);
  EXPECT_FALSE(warningOf(17, swept));
  EXPECT_LT(meanError("one_iteration", swept), 3.0 * meanError("pcg", swept));
}

TEST(OneIterationWarning, saysWhichDerivativesBlowUp) {
  for (const auto derivative : {ForceDerivative::Exact, ForceDerivative::Axial, ForceDerivative::TensionOnly}) {
    StepParameters parameters = with(1e3, 1.0 / 150.0);
    parameters.derivative = derivative;
    EXPECT_EQ(warningOf(17, parameters).value().kind, SolverWarning::Kind::IndefiniteMatrix);
    EXPECT_GT(largestEnergy(17, parameters), 1e3);
    parameters.material.stiffness = 20.0;  // (h omega)^2 = 21
    EXPECT_NE(warningOf(17, parameters).value().kind, SolverWarning::Kind::IndefiniteMatrix);
    EXPECT_LT(largestEnergy(17, parameters), 10.0);
  }
  StepParameters scalar = with(1e5, 1.0 / 30.0);
  scalar.derivative = ForceDerivative::Scalar;
  EXPECT_EQ(warningOf(33, scalar).value().kind, SolverWarning::Kind::TooFewSweeps) << "no energy gain";
}

}  // namespace
}  // namespace drape::sim
