#include "sim/fabric/rest_curvature.hpp"

#include "fabric_cloths.hpp"
#include "sim/simd/sliced_run.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::fabric {
namespace {

using namespace testing;

using Positions = std::vector<Vec3>;

constexpr double radius = 0.1;  // [m]
constexpr double width = 0.05;  // [m]

/// A closed ring about the z axis. @param around number of vertices around it  @param irregular moves vertices in the
/// surface by up to 30 % of a cell
ClothMesh ring(int around, int rows, bool irregular) {
  ClothMesh mesh;
  RandomVectors random(3);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < around; ++column) {
      const Vec3 moved = irregular ? random.next(0.3) : Vec3(Vec3::Zero());
      const double angle = 2.0 * std::numbers::pi * (column + moved.x()) / around;
      const bool inside = row > 0 && row + 1 < rows;
      const double z = width * (row + (inside ? moved.y() : 0.0)) / (rows - 1);
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column < around; ++column) {
      const int next = (column + 1) % around;
      const int a = row * around + column;
      const int b = row * around + next;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

std::shared_ptr<const ClothModel> clothOf(const ClothMesh& mesh, const Material& material, RestCurvature curvature) {
  const auto springs = buildClothModel(mesh, 0.1, MassLumping::Area, {});
  return withFabric(*springs, material, warpAlong(Vec3::UnitZ(), mesh.positions, mesh.triangles), curvature);
}

/// The energy of a roll with another curvature k is B (k - k_rest)^2 / 2 an area.
TEST(RestCurvature, ofARollHasTheEnergyOfTheChangeOfItsCurvature) {
  constexpr double rest = 2.0;  // [1/m]
  const Material material = woven();
  for (const bool irregular : {false, true}) {
    ClothMesh mesh = sheet(41);
    RandomVectors random(7);
    for (Vec3& position : mesh.positions) {
      const Vec3 moved = irregular ? random.next(0.3 / 40) : Vec3(Vec3::Zero());
      position += Vec3(moved.x(), 0.0, moved.z());
    }
    const Positions flat = mesh.positions;
    mesh.positions = rolled(flat, rest);
    const auto springs = buildClothModel(mesh, 0.1, MassLumping::Area, {});
    const auto warp = warpAlong(Vec3::UnitZ(), mesh.positions, mesh.triangles);
    const auto model = withFabric(*springs, material, warp, RestCurvature::Mesh);
    for (const double curvature : {0.5 * rest, 0.9 * rest, rest, 1.1 * rest, 1.5 * rest, -rest}) {
      const Positions positions = rolled(flat, curvature);
      double energy = elasticEnergy(*model, positions);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        energy -= model->fabric->membrane[t].energy(cornersOf(mesh.triangles[t], positions));
      }
      const double exact = 0.5 * material.bendWeft * (curvature - rest) * (curvature - rest);
      EXPECT_NEAR(energy, exact, 0.05 * exact + 2e-4 * material.bendWeft * rest * rest) << curvature << irregular;
    }
  }
}

TEST(RestCurvature, ofAFlatMeshChangesNothing) {
  const ClothMesh mesh = sheet(9);
  const auto flat = clothOf(mesh, woven(), RestCurvature::Flat);
  const auto same = clothOf(mesh, woven(), RestCurvature::Mesh);
  EXPECT_TRUE(same->fabric->restMoments.empty());
  EXPECT_EQ(same->fabric->fingerprint, flat->fabric->fingerprint);
  EXPECT_EQ(same->fabricStiffness, flat->fabricStiffness);
}

TEST(RestCurvature, hasTheForcesOfItsEnergyWithoutSumAndWithoutTorque) {
  const auto model = clothOf(ring(16, 4, true), woven(), RestCurvature::Mesh);
  Positions positions = shaken(*model, 0.01, 5).positions;
  Vec3 sum = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  double largest = 0.0;
  const RestMoments& moments = model->fabric->restMoments;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 force = moments.forceOn(v, positions);
    sum += force;
    torque += positions[v].cross(force);
    largest = std::max(largest, force.norm());
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double step = 1e-4;
      const double before = positions[v][axis];
      positions[v][axis] = before + step;
      const double above = moments.energy(positions);
      positions[v][axis] = before - step;
      const double below = moments.energy(positions);
      positions[v][axis] = before;
      EXPECT_NEAR(force[axis], (below - above) / (2.0 * step), 1e-8 * largest + 1e-12);
    }
  }
  EXPECT_LT(sum.norm(), 1e-12 * largest);
  EXPECT_LT(torque.norm(), 1e-12 * largest);
}

/// The sheet, folded about the line x = 0.5 m. @param angle [degrees]
Positions folded(Positions positions, double angle) {
  const double radians = angle * std::numbers::pi / 180.0;
  for (Vec3& position : positions) {
    const double beyond = std::max(0.0, position.x() - 0.5);
    position.x() -= (1.0 - std::cos(radians)) * beyond;
    position.y() = std::sin(radians) * beyond;
  }
  return positions;
}

TEST(RestCurvature, ofACreaseHasItsLeastEnergyAtTheAngleOfTheMesh) {
  for (const double rest : {-70.0, -30.0, 10.0, 45.0, 80.0}) {
    ClothMesh mesh = sheet(9);
    const Positions flat = mesh.positions;
    mesh.positions = folded(flat, rest);
    const auto model = clothOf(mesh, woven(), RestCurvature::Mesh);
    double lowest = 1.0;
    double found = 0.0;
    for (double angle = -120.0; angle <= 120.0; angle += 1.0) {
      if (const double energy = elasticEnergy(*model, folded(flat, angle)); energy < lowest) {
        lowest = energy;
        found = angle;
      }
    }
    EXPECT_NEAR(found, rest, 1.0);
    EXPECT_NEAR(lowest, 0.0, 1e-9);
  }
}

/// The lowest mode of a ring without stretch, an oval: omega^2 = 36 B / (5 density R^4) (Timoshenko, Vibration problems
/// in engineering).
TEST(RestCurvature, ofARingHasTheFrequencyOfAnOval) {
  const double density = 0.1 / (2.0 * std::numbers::pi * radius * width);
  Material material;
  material.stretchWarp = material.stretchWeft = 500.0;
  material.shear = 250.0;
  material.bendWarp = material.bendWeft = material.bendBias = 1e-4;
  const ClothMesh mesh = ring(64, 5, false);
  const auto model = clothOf(mesh, material, RestCurvature::Mesh);
  std::vector<Vec3> mode;
  ClothState state = stateAtRest(mesh.positions);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double angle = std::atan2(mesh.positions[v].y(), mesh.positions[v].x());
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 along(-std::sin(angle), std::cos(angle), 0.0);
    mode.emplace_back(std::cos(2.0 * angle) * outward - 0.5 * std::sin(2.0 * angle) * along);
    state.velocities[v] = 1e-3 * mode.back();
  }
  StepParameters parameters;
  parameters.timeStep = 2e-4;
  parameters.gravity = 0.0;
  parameters.precision = Precision::Double;
  const double omega = std::sqrt(7.2 * material.bendWarp / density) / (radius * radius);
  simd::SlicedRun run;
  double before = 0.0;
  double halfPeriod = 0.0;
  for (int step = 1; halfPeriod == 0.0 && step * parameters.timeStep < 6.0 / omega; ++step) {
    run.verlet(*model, parameters, {}, 1, state);
    double amplitude = 0.0;
    for (std::size_t v = 0; v < mode.size(); ++v) {
      amplitude += mode[v].dot(state.positions[v] - mesh.positions[v]);
    }
    halfPeriod = amplitude < 0.0 && before > 0.0 ? step * parameters.timeStep : 0.0;
    before = amplitude;
  }
  EXPECT_NEAR(std::numbers::pi / halfPeriod, omega, 0.02 * omega);
}

/// The distance that a free roll moves without gravity in 20 ms [m].
double motionOf(const ClothModel& model, const SolverInfo& solver) {
  StepParameters parameters;
  parameters.gravity = 0.0;
  parameters.precision = Precision::Double;
  parameters.timeStep = 5e-4;
  ClothState state = stateAtRest(model.restPositions);
  const auto method = solver.make();
  for (int step = 0; step < 40; ++step) {
    method->step(model, parameters, {}, state);
  }
  double largest = 0.0;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    largest = std::max(largest, (state.positions[v] - model.restPositions[v]).norm());
  }
  return largest;
}

TEST(RestCurvature, keepsARollAtRestWithEveryStableSolverThatTakesAFabric) {
  ClothMesh mesh = sheet(11);
  mesh.positions = rolled(mesh.positions, 3.0);
  Material material = woven();
  material.bendWarp = material.bendWeft = material.bendBias = 1e-3;
  const auto flat = clothOf(mesh, material, RestCurvature::Flat);
  const auto curved = clothOf(mesh, material, RestCurvature::Mesh);
  for (const SolverInfo& solver : solverTable()) {
    if (solver.takesFabric && solver.name != "explicit_euler") {  // which amplifies every motion
      const double unrolled = motionOf(*flat, solver);
      EXPECT_GT(unrolled, 1e-5) << solver.name;
      EXPECT_LT(motionOf(*curved, solver), 0.05 * unrolled) << solver.name;
    }
  }
}

}  // namespace
}  // namespace drape::sim::fabric
