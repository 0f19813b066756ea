#include "sim/simd/fabric_damper.hpp"

#include "fabric_cloths.hpp"
#include "sim/fabric/membrane.hpp"
#include "simd/simd_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::simd {
namespace {

using namespace testing;

constexpr double step = 1.0 / 150.0;  // [s]

fabric::Material damped(fabric::Material material, double stretch, double bend) {
  material.stretchDamping = stretch;
  material.bendDamping = bend;
  return material;
}

CommonParameters stepOf(Precision precision) {
  CommonParameters parameters;
  parameters.timeStep = step;
  parameters.precision = precision;
  return parameters;
}

/// -Z v of docs/theory/fabric.md, by the derivatives of the energy.
std::vector<Vec3> dampingForces(const ClothModel& model, const ClothState& state) {
  const fabric::Fabric& fabric = *model.fabric;
  fabric::Material linear = fabric.materials[0];
  linear.stiffeningWarp = linear.stiffeningWeft = 0.0;
  std::vector<Vec3> forces(state.positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const Triangle& triangle = model.triangles[t];
    Eigen::Matrix<double, 9, 1> velocities;
    velocities << state.velocities[triangle[0]], state.velocities[triangle[1]], state.velocities[triangle[2]];
    const Eigen::Matrix<double, 9, 1> own =
        fabric::MembraneTriangle(fabric.shape.triangles[t], linear, fabric.membraneScales[t])
            .derivative(fabric::cornersOf(triangle, state.positions), ForceDerivative::Axial) *
        velocities;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      forces[triangle[corner]] -= fabric.materials[0].stretchDamping * own.segment<3>(3 * static_cast<int>(corner));
    }
  }
  if (fabric.bends()) {
    const fabric::BendingDamping damping = fabric::bendingDampingOf(model);
    std::vector<Vec3> rates;
    for (int v = 0; v < model.vertexCount(); ++v) {
      const Vec3 direction = fabric::bendingDirection(model, damping, state.positions, v);
      const Vec3 rate = fabric::weightedLaplacian(model, damping, state.velocities, v);
      rates.push_back(damping.inverseAreas[v] * rate.dot(direction) * direction);
    }
    for (int v = 0; v < model.vertexCount(); ++v) {
      forces[v] -= fabric.materials[0].bendDamping * fabric::weightedLaplacian(model, damping, rates, v);
    }
  }
  return forces;
}

Vec3 momentumOf(const ClothModel& model, const ClothState& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += model.vertexMass[v] * state.velocities[v];
  }
  return sum;
}

Vec3 angularMomentumOf(const ClothModel& model, const ClothState& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += model.vertexMass[v] * state.positions[v].cross(state.velocities[v]);
  }
  return sum;
}

double kineticEnergyOf(const ClothModel& model, const ClothState& state) {
  double sum = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += 0.5 * model.vertexMass[v] * state.velocities[v].squaredNorm();
  }
  return sum;
}

double largestSpeedDifference(const ClothState& a, const ClothState& b) {
  double largest = 0.0;
  for (std::size_t v = 0; v < a.velocities.size(); ++v) {
    largest = std::max(largest, (a.velocities[v] - b.velocities[v]).norm());
  }
  return largest;
}

ClothMesh flatUnevenSheet(int n) {
  ClothMesh mesh = unevenSheet(n, 4);
  for (Vec3& position : mesh.positions) {
    position.y() = 0.0;
  }
  return mesh;
}

class FabricDamperOnEveryMesh : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(FabricDamperOnEveryMesh, acceleratesByTheDampingOfTheFormulas) {
  for (const auto& [name, material] : everyKindOfFabric()) {
    for (const auto& [stretch, bend] : {std::pair(1e-9, 0.0), std::pair(0.0, 1e-8), std::pair(1e-9, 1e-8)}) {
      const auto model = asFabric(*pinnedCloth(GetParam().mesh), damped(material, stretch, bend));
      const ClothState start = shaken(*model, 0.002, 5);
      ClothState state = start;
      FabricDamper().damp(*model, stepOf(Precision::Double), {}, state);
      const std::vector<Vec3> forces = dampingForces(*model, start);
      double largest = 0.0;
      double wrong = 0.0;
      for (std::size_t v = 0; v < forces.size(); ++v) {
        const Vec3 expected = model->pinned[v] ? Vec3(Vec3::Zero()) : Vec3(step / model->vertexMass[v] * forces[v]);
        largest = std::max(largest, expected.norm());
        wrong = std::max(wrong, (state.velocities[v] - start.velocities[v] - expected).norm());
      }
      EXPECT_LE(wrong, 1e-3 * largest + 1e-15) << name << stretch << bend;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FabricDamperOnEveryMesh, ::testing::ValuesIn(everyKindOfMesh()),
                         [](const auto& instance) { return instance.param.name; });

TEST(FabricDamper, leavesRigidMotionAlone) {
  const auto model =
      asFabric(*buildClothModel(flatUnevenSheet(17), 0.1, MassLumping::Area, {}), damped(woven(), 2e-4, 1e-2));
  ClothState start = shaken(*model, 0.0, 3);
  for (std::size_t v = 0; v < start.velocities.size(); ++v) {
    const Vec3 rest = start.positions[v];  // bent to a part of a cylinder
    start.positions[v] = Vec3(0.5 * std::sin(2.0 * rest.x()), -0.5 * std::cos(2.0 * rest.x()), rest.z());
    start.velocities[v] = Vec3(1.0, 2.0, -0.5) + Vec3(0.3, -0.8, 1.1).cross(start.positions[v]);
  }
  for (const auto& [precision, tolerance] : {std::pair(Precision::Double, 1e-5), std::pair(Precision::Float, 1e-4)}) {
    ClothState state = start;
    FabricDamper().damp(*model, stepOf(precision), {}, state);
    EXPECT_LT(largestSpeedDifference(state, start), tolerance);
  }
}

TEST(FabricDamper, leavesTranslationAloneToTheLastBit) {
  const auto model =
      asFabric(*buildClothModel(unevenSheet(17, 4), 0.1, MassLumping::Area, {}), damped(woven(), 1e-2, 1e-2));
  ClothState start = shaken(*model, 0.02, 3);
  std::ranges::fill(start.velocities, Vec3(1.0, 2.0, -0.3));
  for (const Precision precision : {Precision::Double, Precision::Float}) {
    ClothState state = start;
    FabricDamper().damp(*model, stepOf(precision), {}, state);
    EXPECT_EQ(state.velocities, start.velocities);
  }
}

/// The rate [1/s] at which a vibration of a strip along warp decays.
/// @param bends whether it bends across its plane with 3/4 waves, or shears in its plane
double decayRate(bool bends) {
  const fabric::Material material = damped(woven(), 1e-4, 1e-3);
  const auto flat = buildClothModel(flatUnevenSheet(25), 0.1, MassLumping::Area, {});
  const auto model =
      fabric::withFabric(*flat, material, fabric::warpAlong(Vec3::UnitX(), flat->restPositions, flat->triangles));
  constexpr double waveNumber = 3.0 * std::numbers::pi;  // [1/m]
  ClothState state = shaken(*model, 0.0, 3);
  std::vector<Vec3> mode;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    const double wave = std::sin(waveNumber * model->restPositions[v].x());
    mode.emplace_back(bends ? Vec3(0.0, wave, 0.0) : Vec3(0.0, 0.0, wave));
    state.velocities[v] = mode.back();
  }
  CommonParameters parameters = stepOf(Precision::Double);
  parameters.timeStep = 1e-4;
  FabricDamper().damp(*model, parameters, {}, state);
  double before = 0.0;
  double after = 0.0;
  for (std::size_t v = 0; v < mode.size(); ++v) {
    before += model->vertexMass[v] * mode[v].squaredNorm();
    after += model->vertexMass[v] * mode[v].dot(state.velocities[v]);
  }
  return (1.0 - after / before) / parameters.timeStep;
}

TEST(FabricDamper, dampsAWaveByItsStiffnessTimesTheDampingTime) {
  constexpr double waveNumber = 3.0 * std::numbers::pi;
  constexpr double density = 0.1;
  EXPECT_NEAR(decayRate(false) / (1e-4 * woven().shear * std::pow(waveNumber, 2) / density), 1.0, 0.05);
  EXPECT_NEAR(decayRate(true) / (1e-3 * woven().bendWarp * std::pow(waveNumber, 4) / density), 1.0, 0.05);
}

TEST(FabricDamper, conservesMomentumAndTakesEnergy) {
  const auto model = asFabric(*buildClothModel(unevenSheet(17, 4), 0.1, MassLumping::Area, {}),
                              damped(stiffeningFabric(), 1e-3, 1e-2));
  const ClothState start = shaken(*model, 0.01, 3);
  ClothState state = start;
  const double work = FabricDamper().damp(*model, stepOf(Precision::Double), {}, state);
  EXPECT_LT((momentumOf(*model, state) - momentumOf(*model, start)).norm(), 1e-12);
  EXPECT_LT((angularMomentumOf(*model, state) - angularMomentumOf(*model, start)).norm(), 1e-8);
  EXPECT_LT(work, -0.5 * kineticEnergyOf(*model, start));
  EXPECT_NEAR(work, kineticEnergyOf(*model, state) - kineticEnergyOf(*model, start), 1e-15);
}

TEST(FabricDamper, isStableForEveryDampingTime) {
  for (const double time : {1e-5, 1e-3, 1e-1, 1.0}) {
    const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), damped(woven(), time, time));
    ClothState state = shaken(*model, 0.02, 3);
    double energy = kineticEnergyOf(*model, state);
    FabricDamper damper;
    for (int i = 0; i < 5; ++i) {
      damper.damp(*model, stepOf(Precision::Float), {}, state);
      const double next = kineticEnergyOf(*model, state);
      EXPECT_LT(next, energy) << time;
      energy = next;
    }
  }
}

TEST(FabricDamper, isStableWhereTheClothIsStretchedFar) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), damped(woven(), 1e-2, 0.0));
  ClothState state = shaken(*model, 0.02, 3);
  for (Vec3& position : state.positions) {
    position *= 3.0;
  }
  FabricDamper damper;
  for (int i = 0; i < 5; ++i) {
    EXPECT_LT(damper.damp(*model, stepOf(Precision::Float), {}, state), 0.0);
  }
}

TEST(FabricDamper, leavesTheVelocitiesWhereItCannotBeStable) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), damped(woven(), 1e-2, 0.0));
  ClothState state = shaken(*model, 0.02, 3);
  for (Vec3& position : state.positions) {
    position *= 1e4;
  }
  const std::vector<Vec3> before = state.velocities;
  EXPECT_EQ(FabricDamper().damp(*model, stepOf(Precision::Float), {}, state), 0.0);
  EXPECT_EQ(state.velocities, before);
}

/// All pinned vertices with one velocity.
std::vector<PinVelocity> pinsMovingAt(const ClothModel& model, const Vec3& velocity) {
  std::vector<PinVelocity> pins;
  for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
    if (model.pinned[v]) {
      pins.push_back({v, velocity});
    }
  }
  return pins;
}

TEST(FabricDamper, isAsStableWithPinsThatMoveSlowly) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), damped(woven(), 1e-2, 0.0));
  const std::vector<PinVelocity> pins = pinsMovingAt(*model, Vec3(0.0, -1e-3, 0.0));
  for (const double stretch : {3.0, 1e4}) {
    ClothState state = shaken(*model, 0.02, 3);
    for (Vec3& position : state.positions) {
      position *= stretch;
    }
    const double before = kineticEnergyOf(*model, state);
    FabricDamper().damp(*model, stepOf(Precision::Float), pins, state);
    EXPECT_LT(kineticEnergyOf(*model, state), 1.001 * before) << stretch;
  }
}

TEST(FabricDamper, givesTheSameBitsForAnyNumberOfThreads) {
  const auto model = asFabric(*pinnedCloth(renumbered(unevenSheet(65, 4), 6)), damped(woven(), 1e-3, 1e-2));
  const ClothState start = shaken(*model, 0.001, 5);
  ClothState alone = start;
  CommonParameters parameters = stepOf(Precision::Float);
  FabricDamper().damp(*model, parameters, {}, alone);
  for (const int threads : {2, 3}) {
    ClothState together = start;
    parameters.threads = threads;
    FabricDamper().damp(*model, parameters, {}, together);
    EXPECT_EQ(together.velocities, alone.velocities) << threads;
  }
}

TEST(FabricDamper, countsTheVelocityOfPinsThatMove) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), damped(woven(), 1e-3, 1e-2));
  const Vec3 velocity(0.5, 0.2, -1.0);
  ClothState start = stateAtRest(model->restPositions);
  const std::vector<PinVelocity> pins = pinsMovingAt(*model, velocity);
  for (std::size_t v = 0; v < start.velocities.size(); ++v) {
    start.velocities[v] = model->pinned[v] ? Vec3(Vec3::Zero()) : velocity;
  }
  ClothState moving = start;
  FabricDamper().damp(*model, stepOf(Precision::Double), pins, moving);
  EXPECT_EQ(moving.velocities, start.velocities);
  FabricDamper().damp(*model, stepOf(Precision::Double), {}, moving);
  EXPECT_GT(largestSpeedDifference(moving, start), 0.1);
}

TEST(FabricDamper, doesNothingToAFabricWithoutDamping) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(17, 4)), woven());
  ClothState state = shaken(*model, 0.02, 3);
  const ClothState start = state;
  EXPECT_EQ(FabricDamper().damp(*model, stepOf(Precision::Float), {}, state), 0.0);
  EXPECT_EQ(state.velocities, start.velocities);
}

}  // namespace
}  // namespace drape::sim::simd
