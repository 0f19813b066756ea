#include "sim/simd/sliced_fabric.hpp"

#include "fabric_cloths.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/forces/stability.hpp"
#include "sim/simd/sliced_run.hpp"
#include "simd/simd_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace drape::sim::simd {
namespace {

using namespace testing;

/// A step of Stoermer-Verlet with the forces of the reference implementation.
void referenceStep(const ClothModel& model, const CommonParameters& parameters, ClothState& state) {
  const double h = parameters.timeStep;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.positions[v] += 0.5 * h * state.velocities[v];
  }
  std::vector<Vec3> forces;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    forces.push_back(internalForceOn(model, parameters, state, v) + gravityAndAir(model, parameters, state, v));
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!model.pinned[v]) {
      state.velocities[v] += h / model.vertexMass[v] * forces[v];
      state.positions[v] += 0.5 * h * state.velocities[v];
    }
  }
}

/// The state after some of these steps.
ClothState afterReferenceSteps(const ClothModel& model, const CommonParameters& parameters, ClothState state,
                               int steps) {
  for (int i = 0; i < steps; ++i) {
    referenceStep(model, parameters, state);
  }
  return state;
}

double largestSpeed(const ClothState& state) {
  double largest = 0.0;
  for (const Vec3& velocity : state.velocities) {
    largest = std::max(largest, velocity.norm());
  }
  return largest;
}

class SlicedFabricOnEveryMesh : public ::testing::TestWithParam<NamedMesh> {};

TEST_P(SlicedFabricOnEveryMesh, movesTheClothAsTheFormulasDo) {
  for (const auto& [name, model] : withEveryFabric(*pinnedCloth(GetParam().mesh))) {
    StepParameters parameters = windyStep();
    parameters.timeStep = 1e-4;
    for (const bool windy : {true, false}) {
      parameters.air.drag = parameters.air.lift = windy ? 0.6 : 0.0;
      const ClothState start = shaken(*model, 0.002, 5);
      const ClothState expected = afterReferenceSteps(*model, parameters, start, 3);
      SlicedRun run;
      ClothState state = start;
      parameters.precision = Precision::Double;
      run.verlet(*model, parameters, {}, 3, state);
      EXPECT_LT(largestDifference(state, expected), 1e-10 * largestSpeed(expected)) << name << windy;
      state = start;
      parameters.precision = Precision::Float;
      run.verlet(*model, parameters, {}, 3, state);
      EXPECT_LT(largestDifference(state, expected), 1e-3 * largestSpeed(expected)) << name << windy;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, SlicedFabricOnEveryMesh, ::testing::ValuesIn(everyKindOfMesh()),
                         [](const auto& instance) { return instance.param.name; });

/// Elastic and kinetic energy by the kernel [J], but for a constant if the fabric is bent at rest.
double kernelEnergy(const ClothModel& model, const ClothState& state) {
  SlicedCloth<double> cloth(model);
  cloth.prepare(1, 1);
  const StepShare share = shareOf(cloth.layout, 1, 0, 1);
  cloth.load(state, share);
  SliceStep<double> still = sliceStepOf<double>(StepParameters{}, {});
  still.timeStep = 0.0;
  still.gravity = 0.0;
  std::vector<double> energies(static_cast<std::size_t>(cloth.layout.slices()) * sliceLanes, 0.0);
  still.energy = energies.data();
  verletPhase(cloth, still, 0.0, share, 0);
  return std::accumulate(energies.begin(), energies.begin() + static_cast<std::ptrdiff_t>(state.positions.size()), 0.0);
}

TEST(SlicedFabric, storesNothingOfBendingIfTheFabricDoesNotResistIt) {
  fabric::Material material = woven();
  const auto springs = pinnedCloth(sheet(5));
  const auto sliced = [&] {
    const auto model = fabric::withFabric(*springs, material,
                                          fabric::warpAlong(Vec3::UnitX(), springs->restPositions, springs->triangles));
    SliceLayout layout = buildSliceLayout(*model);
    return std::pair{model, buildSlicedFabric<float>(*model, layout)};
  };
  EXPECT_TRUE(sliced().second.bending.has_value());
  material.bendWarp = material.bendWeft = material.bendBias = 0.0;
  const auto [model, membrane] = sliced();
  EXPECT_FALSE(membrane.bending.has_value());
  EXPECT_EQ(model->fabric->bending.nonZeros(), 0);
  EXPECT_TRUE(model->fabric->bendingScales.empty());
}

TEST(SlicedFabric, findsTheEnergyOfTheReferenceImplementation) {
  for (const auto& [name, model] : withEveryFabric(*pinnedCloth(renumbered(unevenSheet(17, 4), 6)))) {
    const ClothState state = shaken(*model, 0.002, 5);
    const ClothState rest = stateAtRest(model->restPositions);
    const Energy atRest = energyOf(*model, StepParameters{}, rest);
    const Energy expected = energyOf(*model, StepParameters{}, state);
    const double zero = model->fabric->restMoments.empty() ? 0.0 : kernelEnergy(*model, rest) - atRest.elastic;
    const double energy = kernelEnergy(*model, state) - zero;
    EXPECT_NEAR(energy, expected.elastic + expected.kinetic, 1e-10 * energy) << name;
  }
}

TEST(SlicedFabric, takesTrianglesThatFaceEitherSideAndEdgesOfThreeTriangles) {
  ClothMesh mesh = renumbered(unevenSheet(15, 9), 4);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  mesh.positions.emplace_back(mesh.positions[mesh.triangles[40][0]] + Vec3(0.0, 0.1, 0.0));
  mesh.triangles.push_back({mesh.triangles[40][0], mesh.triangles[40][1], static_cast<int>(mesh.positions.size()) - 1});
  const auto model = asFabric(*pinnedCloth(mesh), stiffeningFabric());
  StepParameters parameters = windyStep();
  parameters.timeStep = 1e-4;
  parameters.precision = Precision::Double;
  ClothState state = shaken(*model, 0.002, 5);
  ClothState expected = state;
  SlicedRun run;
  run.verlet(*model, parameters, {}, 3, state);
  for (int i = 0; i < 3; ++i) {
    referenceStep(*model, parameters, expected);
  }
  EXPECT_LT(largestDifference(state, expected), 1e-10 * largestSpeed(expected));
}

/// On a grid, whose slices have common corners except at the seam, and on an irregular mesh.
TEST(SlicedFabric, takesAPatternWhoseSidesOfASeamDiffer) {
  for (const ClothMesh& mesh : {sheet(25), renumbered(unevenSheet(17, 4), 6)}) {
    for (const auto& [name, material] : everyKindOfFabric()) {
      const auto springs = pinnedCloth(mesh);
      const auto model = fabric::withPatternFabric(*springs, material, twoPieces(*springs, 1.01, 1.03));
      StepParameters parameters = windyStep();
      parameters.timeStep = 5e-5;
      parameters.precision = Precision::Double;
      const ClothState start = shaken(*model, 0.002, 5);
      const ClothState expected = afterReferenceSteps(*model, parameters, start, 3);
      SlicedRun run;
      ClothState state = start;
      run.verlet(*model, parameters, {}, 3, state);
      EXPECT_LT(largestDifference(state, expected), 1e-10 * largestSpeed(expected)) << name;
      ClothState threaded = start;
      parameters.threads = 3;
      run.verlet(*model, parameters, {}, 3, threaded);
      EXPECT_EQ(largestDifference(state, threaded), 0.0) << name;
    }
  }
}

TEST(SlicedFabric, conservesEnergyBelowTheStabilityLimit) {
  const auto model = asFabric(*pinnedCloth(sheet(13)), woven());
  StepParameters parameters;
  parameters.timeStep = 0.5 / largestFrequency(*model, parameters);
  ClothState state = shaken(*model, 0.002, 5);
  const double start = energyOf(*model, parameters, state).total();
  SlicedRun run;
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    run.verlet(*model, parameters, {}, 10, state);
    worst = std::max(worst, std::abs(energyOf(*model, parameters, state).total() - start));
  }
  EXPECT_LT(worst, 0.02 * std::abs(start));
}

TEST(SlicedFabric, keepsNothingOfAnUnstableStep) {
  const auto model = asFabric(*pinnedCloth(unevenSheet(15, 3)), woven());
  const ClothState start = shaken(*model, 0.002, 5);
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    StepParameters parameters;
    parameters.precision = precision;
    SlicedRun run;
    ClothState unstable = start;
    parameters.timeStep = 1.0;
    run.verlet(*model, parameters, {}, 50, unstable);
    EXPECT_FALSE(isFinite(unstable));
    parameters.timeStep = 1e-4;
    ClothState after = start;
    run.verlet(*model, parameters, {}, 10, after);
    ClothState fresh = start;
    SlicedRun().verlet(*model, parameters, {}, 10, fresh);
    EXPECT_EQ(after.positions, fresh.positions);
  }
}

TEST(SlicedFabric, isRebuiltForAnotherMaterialAndForSprings) {
  const auto springs = pinnedCloth(sheet(9));
  const ClothState start = shaken(*springs, 0.002, 5);
  StepParameters parameters;
  parameters.timeStep = 1e-4;
  const auto moved = [&](SlicedRun& run, const ClothModel& model) {
    ClothState state = start;
    run.verlet(model, parameters, {}, 3, state);
    return stateHash(state);
  };
  SlicedRun shared;
  for (const auto& model : {springs, asFabric(*springs, woven()), asFabric(*springs, membraneOnly()), springs}) {
    SlicedRun own;
    EXPECT_EQ(moved(shared, *model), moved(own, *model));
  }
}

TEST(SlicedFabric, hasTheSameBitsWithAnyNumberOfThreads) {
  const auto model = asFabric(*pinnedCloth(renumbered(unevenSheet(60, 3), 4)), stiffeningFabric());
  StepParameters parameters = windyStep();
  parameters.timeStep = 1e-5;
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2}) {
    parameters.threads = threads;
    ClothState state = shaken(*model, 0.0005, 3);
    SlicedRun run;
    run.verlet(*model, parameters, {}, 5, state);
    hashes.push_back(stateHash(state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace drape::sim::simd
