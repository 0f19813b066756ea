#include "fabric_cloths.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace drape::sim::fabric {
namespace {

using namespace testing;

/// The highest angular frequency at rest [1/s], by power iteration on the linearised forces.
double highestFrequency(const ClothModel& model) {
  constexpr double small = 1e-6;  // [m]
  RandomVectors random(3);
  std::vector<Vec3> mode(model.restPositions.size());
  for (Vec3& vector : mode) {
    vector = random.next(1.0);
  }
  ClothState state = stateAtRest(model.restPositions);
  std::vector<Vec3> atRest;  // the bending of a rest shape that is not flat [N]
  for (std::size_t v = 0; v < mode.size(); ++v) {
    atRest.push_back(internalForceOn(model, {}, state, v));
  }
  double squared = 0.0;
  for (int i = 0; i < 400; ++i) {
    double norm = 0.0;
    for (const Vec3& vector : mode) {
      norm += vector.squaredNorm();
    }
    for (std::size_t v = 0; v < mode.size(); ++v) {
      state.positions[v] = model.restPositions[v] + small / std::sqrt(norm) * mode[v];
    }
    double potential = 0.0;
    double kinetic = 0.0;
    for (std::size_t v = 0; v < mode.size(); ++v) {
      const Vec3 displacement = state.positions[v] - model.restPositions[v];
      const Vec3 force = atRest[v] - internalForceOn(model, {}, state, v);
      potential += displacement.dot(force);
      kinetic += model.vertexMass[v] * displacement.squaredNorm();
      mode[v] = force / model.vertexMass[v];
    }
    squared = potential / kinetic;
  }
  return std::sqrt(squared);
}

/// A sheet of one diagonal a quad, of alternating diagonals, or with displaced vertices.
std::vector<std::shared_ptr<const ClothModel>> threeKindsOfSheet() {
  ClothMesh alternating = sheet(9);
  for (std::size_t t = 0; t < alternating.triangles.size(); t += 4) {
    const Triangle first = alternating.triangles[t];
    const Triangle second = alternating.triangles[t + 1];
    alternating.triangles[t] = {first[0], first[1], second[2]};
    alternating.triangles[t + 1] = {second[2], first[1], first[2]};
  }
  return {buildClothModel(sheet(9), 0.1, MassLumping::Area, {}),
          buildClothModel(alternating, 0.1, MassLumping::Area, {}), irregularSheet(9, {})};
}

TEST(FabricFrequency, isEstimatedATenthAboveTheHighestFrequencyAtRest) {
  for (const Material& material : {membraneOnly(), woven()}) {
    for (const MassLumping lumping : {MassLumping::Area, MassLumping::Uniform}) {
      int kind = 0;
      for (const auto& springs : threeKindsOfSheet()) {
        const auto model = asFabric(*withMass(*springs, 0.1, lumping), material);
        const double ratio = largestFrequency(*model, {}) / highestFrequency(*model);
        EXPECT_GT(ratio, 1.06) << "kind " << kind;
        EXPECT_LT(ratio, 1.12) << "kind " << kind;
        ++kind;
      }
    }
  }
}

TEST(FabricFrequency, limitsTheStepWhateverTheStiffnessAndDampingOfSprings) {
  const auto model = asFabric(*threeKindsOfSheet()[0], woven());
  StepParameters undamped;
  undamped.material = {.stiffness = 1.0, .damping = 0.0};
  StepParameters damped;
  damped.material = {.stiffness = 77.0, .damping = 0.1};
  EXPECT_EQ(largestFrequency(*model, damped), model->unitFrequency);
  EXPECT_NEAR(verletStepLimit(*model, damped), 2.0 / model->unitFrequency, 1e-12 / model->unitFrequency);
  int limited = 0;
  for (const SolverInfo& solver : solverTable()) {
    if (solver.takesFabric && solver.stepLimit != nullptr) {
      EXPECT_EQ(solver.stepLimit(*model, damped), solver.stepLimit(*model, undamped)) << solver.name;
      ++limited;
    }
  }
  EXPECT_GE(limited, 2);
  EXPECT_EQ(findSolver("explicit_euler")->stepLimit(*model, damped), 0.0) << "no undamped step is stable";
}

TEST(FabricFrequency, keepsVerletStableWhereTheWholeBoundaryIsPinned) {
  constexpr int n = 17;
  std::vector<int> boundary;
  for (int i = 0; i < n; ++i) {
    for (const int vertex : {i, (n - 1) * n + i, i * n, i * n + n - 1}) {
      boundary.push_back(vertex);
    }
  }
  fabric::Material isotropic = membraneOnly();
  isotropic.stretchWarp = isotropic.stretchWeft = 1000.0;
  isotropic.shear = 500.0;
  isotropic.poisson = 0.0;
  const auto model = asFabric(*buildClothModel(sheet(n), 0.1, MassLumping::Area, boundary), isotropic);
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.timeStep = 0.98 * verletStepLimit(*model, parameters);
  ClothState state = stateAtRest(model->restPositions);
  RandomVectors random(5);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    const Vec3 move = random.next(1e-6);
    state.positions[v] += model->pinned[v] ? Vec3::Zero() : move;
  }
  const auto solver = findSolver("verlet")->make();
  for (int step = 0; step < 1000; ++step) {
    solver->step(*model, parameters, {}, state);
  }
  double largest = 0.0;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    largest = std::max(largest, (state.positions[v] - model->restPositions[v]).norm());
  }
  EXPECT_LT(largest, 1e-3);
}

}  // namespace
}  // namespace drape::sim::fabric
