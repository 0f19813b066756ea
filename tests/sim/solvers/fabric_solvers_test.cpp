#include "fabric_cloths.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"
#include "sim/measures/measures.hpp"
#include "sim/model/sim_error.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/stepping/stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drape::sim {
namespace {

using namespace testing;

ClothState movedBy(const char* solver, const ClothModel& model, const StepParameters& parameters, int steps,
                   ClothState state) {
  Stepper stepper(solver);
  for (int i = 0; i < steps; ++i) {
    stepper.step(model, parameters, {}, state);
  }
  return state;
}

double distanceBetween(const ClothState& a, const ClothState& b) {
  return meanDistance(a.positions, b.positions);
}

TEST(SolversWithFabric, newtonSolvesTheBackwardEulerStep) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(9), material);
    StepParameters parameters;
    parameters.timeStep = 1.0 / 60.0;
    parameters.iteration.tolerance = 1e-12;
    parameters.iteration.maxIterations = 200;
    const ClothState start = shaken(*model, 0.002, 5);
    ClothState end = start;
    Stepper stepper("newton");
    const StepReport report = stepper.step(*model, parameters, {}, end);
    EXPECT_TRUE(report.converged) << name << report.residual;
    double worst = 0.0;
    double size = 0.0;
    for (std::size_t v = 0; v < end.positions.size(); ++v) {
      if (!model->pinned[v]) {
        const Vec3 force =
            internalForceOn(*model, parameters, end, v) - Vec3(0.0, model->vertexMass[v] * parameters.gravity, 0.0);
        const Vec3 change = model->vertexMass[v] * (end.velocities[v] - start.velocities[v]);
        worst = std::max(worst, (change - parameters.timeStep * force).norm());
        size = std::max(size, change.norm());
      }
    }
    EXPECT_LT(worst, 1e-7 * size) << name;
  }
}

TEST(SolversWithFabric, agreeOnTheMotionWithSmallSteps) {
  const auto model = asFabric(*pinnedSheet(7), woven());
  StepParameters parameters;
  parameters.timeStep = 1.0 / 20000.0;
  parameters.precision = Precision::Double;
  const ClothState start = stateAtRest(model->restPositions);
  const ClothState reference = movedBy("verlet", *model, parameters, 4000, start);
  parameters.iteration.tolerance = 1e-6;
  for (const char* solver : {"newton", "pcg", "chebyshev", "one_iteration", "vbd", "xpbd"}) {
    EXPECT_LT(distanceBetween(movedBy(solver, *model, parameters, 4000, start), reference), 1e-3) << solver;
  }
  parameters.timeStep = 1.0 / 200.0;
  parameters.automatic.errorTolerance = 1e-5;
  parameters.automatic.costBudget = 1000.0;
  EXPECT_LT(distanceBetween(movedBy("auto", *model, parameters, 40, start), reference), 1e-4);
}

TEST(SolversWithFabric, manySweepsOfOneIterationSolveTheSystemOfConjugateGradients) {
  const auto model = asFabric(*pinnedSheet(7), woven());
  StepParameters parameters;
  parameters.timeStep = 1.0 / 200.0;
  parameters.iteration.tolerance = 1e-12;
  parameters.iteration.maxIterations = 1000;
  const ClothState start = shaken(*model, 0.005, 5);
  const ClothState solved = movedBy("pcg", *model, parameters, 1, start);
  const double change = distanceBetween(start, solved);
  double before = change;
  for (const int sweeps : {1, 11, 101, 1001}) {
    parameters.jacobi.sweeps = sweeps;
    const double error = distanceBetween(movedBy("one_iteration", *model, parameters, 1, start), solved);
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 1e-5 * change);
  parameters.iteration.iterations = 41;
  parameters.iteration.spectralRadius = 0.98;
  parameters.jacobi.sweeps = 41;
  const double plain = distanceBetween(movedBy("one_iteration", *model, parameters, 1, start), solved);
  EXPECT_LT(distanceBetween(movedBy("chebyshev", *model, parameters, 1, start), solved), 0.5 * plain);
}

TEST(SolversWithFabric, vertexBlockDescentConvergesToNewtonsStep) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(7), material);
    StepParameters parameters;
    parameters.timeStep = 1.0 / 200.0;
    parameters.iteration.tolerance = 1e-12;
    parameters.iteration.maxIterations = 200;
    const ClothState start = shaken(*model, 0.001, 5);
    const ClothState solved = movedBy("newton", *model, parameters, 1, start);
    double before = distanceBetween(start, solved);
    for (const int iterations : {3, 30, 300}) {
      parameters.iteration.iterations = iterations;
      const double error = distanceBetween(movedBy("vbd", *model, parameters, 1, start), solved);
      EXPECT_LT(error, 0.7 * before) << name << iterations;
      before = error;
    }
    EXPECT_LT(before, 1e-5 * distanceBetween(start, solved)) << name;
  }
}

/// A sheet with a vertex so near to an edge that a triangle is a sliver, whose stiffness is scaled down.
std::shared_ptr<const ClothModel> sheetWithASliver() {
  ClothMesh mesh = sheet(7);
  mesh.positions[24] = 0.98 * mesh.positions[23] + 0.02 * mesh.positions[24];
  return buildClothModel(mesh, 0.1, MassLumping::Area, {0});
}

TEST(SolversWithFabric, xpbdConvergesToNewtonsStep) {
  for (const auto& springs : {pinnedSheet(7), irregularSheet(7), sheetWithASliver()}) {
    for (const auto& [name, material] : everyKindOfFabric()) {
      const auto model = asFabric(*springs, material);
      for (const double timeStep : {1.0 / 200.0, 1.0 / 60.0}) {
        StepParameters parameters;
        parameters.timeStep = timeStep;
        parameters.iteration.tolerance = 1e-13;
        parameters.iteration.maxIterations = 300;
        const ClothState start = shaken(*model, 0.001, 5);
        const ClothState solved = movedBy("newton", *model, parameters, 1, start);
        const double change = distanceBetween(start, solved);
        double before = change;
        for (const int iterations : {3, 30, 300}) {
          parameters.iteration.iterations = iterations;
          const double error = distanceBetween(movedBy("xpbd", *model, parameters, 1, start), solved);
          EXPECT_LT(error, 0.7 * before) << name << iterations;
          before = error;
        }
        parameters.iteration.iterations = 3000;
        EXPECT_LT(distanceBetween(movedBy("xpbd", *model, parameters, 1, start), solved), 1e-8 * change) << name;
      }
    }
  }
}

/// Without rotation of the triangles the paper's sums of corrections would agree too. So this start turns them.
TEST(SolversWithFabric, xpbdConvergesToNewtonsStepWhereTrianglesTurn) {
  const auto model = asFabric(*irregularSheet(7, {}), stiffeningFabric());
  StepParameters parameters;
  parameters.timeStep = 1.0 / 200.0;
  parameters.iteration.tolerance = 1e-13;
  parameters.iteration.maxIterations = 300;
  parameters.iteration.iterations = 3000;
  ClothState start = stateAtRest(model->restPositions);
  for (std::size_t v = 0; v < start.positions.size(); ++v) {
    start.velocities[v] = Vec3(10.0, 20.0, 30.0).cross(start.positions[v]);  // 0.19 rad in the step
  }
  const ClothState solved = movedBy("newton", *model, parameters, 1, start);
  EXPECT_LT(distanceBetween(movedBy("xpbd", *model, parameters, 1, start), solved),
            1e-10 * distanceBetween(start, solved));
}

TEST(SolversWithFabric, xpbdKeepsTheMomentumOfFreeCloth) {
  const auto model = asFabric(*irregularSheet(7, {}), stiffeningFabric());
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air = {};
  parameters.timeStep = 1.0 / 60.0;
  parameters.iteration.iterations = 2;
  const ClothState start = shaken(*model, 0.005, 5);
  const ClothState end = movedBy("xpbd", *model, parameters, 20, start);
  Vec3 change = Vec3::Zero();
  double size = 0.0;
  for (std::size_t v = 0; v < end.positions.size(); ++v) {
    change += model->vertexMass[v] * (end.velocities[v] - start.velocities[v]);
    size += model->vertexMass[v] * start.velocities[v].norm();
  }
  EXPECT_LT(change.norm(), 1e-11 * size);
}

TEST(SolversWithFabric, xpbdLeavesAFabricAtRest) {
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.timeStep = 1.0 / 60.0;
  const auto flat = asFabric(*pinnedSheet(7), woven());
  const ClothState start = stateAtRest(flat->restPositions);
  EXPECT_LT(largestDifference(movedBy("xpbd", *flat, parameters, 20, start), start), 1e-12);
  // A flat rest shape bends a mesh that is not flat, so without bending.
  const auto uneven = asFabric(*irregularSheet(7, {}), membraneOnly());
  const ClothState still = stateAtRest(uneven->restPositions);
  EXPECT_LT(largestDifference(movedBy("xpbd", *uneven, parameters, 20, still), still), 1e-12);
}

/// A crushed sheet stores a finite energy, and a correction must not throw its triangles far apart.
TEST(SolversWithFabric, xpbdGainsNoEnergyFromCollapsedTriangles) {
  for (const int iterations : {3, 10}) {
    const auto model = asFabric(*irregularSheet(9, {}), woven());
    StepParameters parameters;
    parameters.gravity = 0.0;
    parameters.timeStep = 1.0 / 60.0;
    parameters.iteration.iterations = iterations;
    ClothState state = shaken(*model, 1e-3, 5);
    for (Vec3& position : state.positions) {
      position *= 1e-3;
    }
    const double start = energyOf(*model, parameters, state).total();
    for (int i = 0; i < 100; ++i) {
      state = movedBy("xpbd", *model, parameters, 1, state);
      ASSERT_LT(energyOf(*model, parameters, state).total(), start) << iterations;
    }
  }
}

TEST(SolversWithFabric, solversThatColourHaveTheSameBitsWithAnyNumberOfThreads) {
  const auto model = asFabric(*irregularSheet(65), woven());
  for (const char* solver : {"vbd", "xpbd"}) {
    StepParameters parameters;
    parameters.timeStep = 1.0 / 200.0;
    parameters.iteration.iterations = 5;
    const ClothState start = shaken(*model, 0.001, 5);
    const ClothState one = movedBy(solver, *model, parameters, 2, start);
    parameters.threads = 3;
    EXPECT_EQ(stateHash(movedBy(solver, *model, parameters, 2, start)), stateHash(one)) << solver;
  }
}

/// Block Jacobi with the diagonal blocks alone blows up within a few steps.
TEST(SolversWithFabric, oneIterationStaysBoundedFarAboveTheExplicitLimit) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(9), material);
    StepParameters parameters;
    parameters.gravity = 0.0;
    parameters.timeStep = 50.0 * verletStepLimit(*model, parameters);
    for (const char* solver : {"one_iteration", "chebyshev", "pcg"}) {
      ClothState state = shaken(*model, 0.001, 5);
      const double start = energyOf(*model, parameters, state).total();
      state = movedBy(solver, *model, parameters, 300, state);
      EXPECT_LT(energyOf(*model, parameters, state).total(), start) << name << solver;
    }
  }
}

TEST(SolversWithFabric, implicitSolversKeepTheMomentumOfTheSolvedSystem) {
  const auto model = asFabric(*irregularSheet(7, {}), woven());
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.air = {};
  parameters.timeStep = 0.005;
  parameters.iteration.tolerance = 1e-12;
  parameters.iteration.maxIterations = 1000;
  const ClothState start = shaken(*model, 0.005, 5);
  const ClothState end = movedBy("pcg", *model, parameters, 5, start);
  Vec3 before = Vec3::Zero();
  Vec3 after = Vec3::Zero();
  double size = 0.0;
  for (std::size_t v = 0; v < end.positions.size(); ++v) {
    before += model->vertexMass[v] * start.velocities[v];
    after += model->vertexMass[v] * end.velocities[v];
    size += model->vertexMass[v] * end.velocities[v].norm();
  }
  EXPECT_LT((after - before).norm(), 1e-9 * size);
}

TEST(SolversWithFabric, autoGainsNoEnergyFromAViolentStart) {
  const auto model = asFabric(*pinnedSheet(9), woven());
  StepParameters parameters;
  parameters.timeStep = 1.0 / 60.0;
  ClothState state = shaken(*model, 0.05, 7);
  const double start = energyOf(*model, parameters, state).total();
  Stepper stepper("auto");
  double largest = start;
  for (int i = 0; i < 60; ++i) {
    stepper.step(*model, parameters, {}, state);
    ASSERT_TRUE(isFinite(state));
    largest = std::max(largest, energyOf(*model, parameters, state).total());
  }
  EXPECT_LT(largest - start, 0.02 * std::abs(start));
}

TEST(SolversWithFabric, ignoreTheMaterialOfSprings) {
  const auto model = asFabric(*pinnedSheet(7), woven());
  for (const char* solver : {"auto", "verlet", "newton"}) {
    StepParameters parameters;
    parameters.timeStep = 1.0 / 2000.0;
    const ClothState start = shaken(*model, 0.002, 5);
    const ClothState soft = movedBy(solver, *model, parameters, 5, start);
    parameters.material = {.stiffness = 5000.0, .damping = 0.1};
    EXPECT_EQ(stateHash(movedBy(solver, *model, parameters, 5, start)), stateHash(soft)) << solver;
  }
}

TEST(SolversWithFabric, refuseItWhereTheyKnowSpringsOnly) {
  const auto model = asFabric(*pinnedSheet(5), woven());
  for (const SolverInfo& info : solverTable()) {
    ClothState state = stateAtRest(model->restPositions);
    Stepper stepper(info.name);
    StepParameters parameters;
    parameters.timeStep = 1e-4;
    if (info.takesFabric) {
      EXPECT_NO_THROW(stepper.step(*model, parameters, {}, state)) << info.name;
    } else {
      EXPECT_THROW(stepper.step(*model, parameters, {}, state), NoFabricSolver) << info.name;
      EXPECT_EQ(state.time, 0.0);
    }
  }
}

TEST(SolversWithFabric, areStableUpToTheEstimatedLimitAtRestAndStretchedBeyondTheStartOfStiffening) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    const auto model = asFabric(*irregularSheet(11), material);
    StepParameters parameters;
    parameters.gravity = 0.0;
    const double limit = verletStepLimit(*model, parameters);
    for (const double stretch : {1.0, 1.02}) {
      parameters.timeStep = (stretch > 1.0 ? 0.7 : 1.0) * limit;  // strain stiffens every fabric a little
      ClothState state = shaken(*model, 1e-7, 5);
      for (Vec3& position : state.positions) {
        position *= stretch;
      }
      const double start = energyOf(*model, parameters, state).total();
      state = movedBy("verlet", *model, parameters, 2000, state);
      EXPECT_LT(energyOf(*model, parameters, state).total(), 10.0 * start) << name << stretch;
    }
  }
}

}  // namespace
}  // namespace drape::sim
