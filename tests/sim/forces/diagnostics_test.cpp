#include "sim/forces/diagnostics.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::sim {
namespace {

TEST(Energy, isZeroAtRest) {
  const auto model = testing::pinnedSheet(4);
  const Energy energy = energyOf(*model, {}, stateAtRest(model->restPositions));
  EXPECT_EQ(energy.total(), 0.0);
}

TEST(Energy, hasTheClosedFormForASheetThatIsScaledLiftedAndMoved) {
  const auto model = testing::pinnedSheet(4);
  StepParameters parameters;
  ClothState state = stateAtRest(model->restPositions);
  double elastic = 0.0;
  for (const Spring& spring : model->springs) {
    elastic += 0.5 * parameters.material.stiffness * 0.04 * spring.restLength * spring.restLength;
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.positions[v] = 1.2 * state.positions[v] + Vec3(0.0, 2.0, 0.0);
    state.velocities[v] = Vec3(0.0, 0.0, 3.0);
  }
  const Energy energy = energyOf(*model, parameters, state);
  EXPECT_NEAR(energy.kinetic, 0.5 * 0.1 * 9.0, 1e-13);
  EXPECT_NEAR(energy.potential, 0.1 * parameters.gravity * 2.0, 1e-13);
  EXPECT_NEAR(energy.elastic, elastic, 1e-12);
  EXPECT_NEAR(maxStretch(*model, state), 0.2, 1e-13);
}

TEST(MeanEdge, isTheMeanOfTheSpringsAtRest) {
  const auto model = testing::pinnedSheet(4);  // 24 sides of 1/3 m and 9 diagonals
  EXPECT_NEAR(meanEdge(*model), (24.0 + 9.0 * std::sqrt(2.0)) / 3.0 / 33.0, 1e-15);
  EXPECT_EQ(meanEdge(ClothModel()), 0.0);
}

TEST(MaxStretch, isZeroWhereEverythingIsCompressed) {
  const auto model = testing::pinnedSheet(4);
  ClothState state = stateAtRest(model->restPositions);
  for (Vec3& position : state.positions) {
    position *= 0.5;
  }
  EXPECT_EQ(maxStretch(*model, state), 0.0);
}

}  // namespace
}  // namespace drape::sim
