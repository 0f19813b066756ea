#include "sim/measures/hanging_load.hpp"

#include "fabric_cloths.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace drape::sim {
namespace {

/// The sheet of the other tests, pinned along its first row.
std::shared_ptr<const ClothModel> hungSheet(int n, double mass) {
  std::vector<int> row(n);
  std::iota(row.begin(), row.end(), 0);
  return buildClothModel(testing::sheet(n), mass, MassLumping::Area, row);
}

TEST(StrainByWeight, IsTheWeightOverWhatTheUpperRowOfSpringsBears) {
  constexpr int n = 11;
  const auto model = hungSheet(n, 0.2);
  StepParameters parameters;
  parameters.material.stiffness = 5.0;
  double weight = 0.0;
  for (std::size_t v = n; v < model->vertexMass.size(); ++v) {
    weight += model->vertexMass[v] * parameters.gravity;
  }
  // n springs along the pull, and n - 1 diagonals at 45 degrees, each of which carries half as much as the others.
  const double edge = 1.0 / (n - 1);
  const double borne = parameters.material.stiffness * edge * (n + 0.5 * (n - 1));
  EXPECT_NEAR(strainByWeight(*model, parameters), weight / borne, 1e-9 * weight / borne);
}

TEST(StrainByWeight, GrowsWithWeightAndFallsWithStiffness) {
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  const double strain = strainByWeight(*hungSheet(9, 0.1), parameters);
  EXPECT_NEAR(strainByWeight(*hungSheet(9, 0.4), parameters), 4.0 * strain, 1e-9);
  parameters.material.stiffness = 40.0;
  EXPECT_NEAR(strainByWeight(*hungSheet(9, 0.1), parameters), strain / 4.0, 1e-9);
  parameters.gravity = 0.0;
  EXPECT_EQ(strainByWeight(*hungSheet(9, 0.1), parameters), 0.0);
}

TEST(StrainByWeight, IsLargerWhereFewPinsCarryAll) {
  StepParameters parameters;
  parameters.material.stiffness = 10.0;
  const auto corners = buildClothModel(testing::sheet(9), 0.1, MassLumping::Area, {0, 8});
  EXPECT_GT(strainByWeight(*corners, parameters), 2.0 * strainByWeight(*hungSheet(9, 0.1), parameters));
}

/// The strain of a sheet without contraction that hangs from one edge: its weight over width and modulus.
TEST(StrainByWeight, OfAFabricFollowsItsModuliAndNotTheSpringsStiffness) {
  fabric::Material material = testing::woven();
  material.stretchWarp = material.stretchWeft = 20.0;
  const auto model = testing::asFabric(*hungSheet(21, 0.5), material);
  const double exact = 0.5 * 9.81 / 20.0;
  for (const double stiffness : {0.0, 1e3}) {
    StepParameters parameters;
    parameters.material.stiffness = stiffness;
    EXPECT_GT(strainByWeight(*model, parameters), 0.5 * exact);
    EXPECT_LT(strainByWeight(*model, parameters), exact);
  }
}

TEST(StrainByWeight, IsNothingWithoutPinsAndInfiniteWithoutStiffness) {
  StepParameters parameters;
  EXPECT_EQ(strainByWeight(*buildClothModel(testing::sheet(5), 0.1, MassLumping::Area, {}), parameters), 0.0);
  parameters.material.stiffness = 0.0;
  EXPECT_TRUE(std::isinf(strainByWeight(*hungSheet(5, 0.1), parameters)));
}

}  // namespace
}  // namespace drape::sim
