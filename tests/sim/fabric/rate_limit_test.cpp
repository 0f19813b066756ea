#include "sim/fabric/rate_limit.hpp"

#include "fabric_cloths.hpp"
#include "sim/fabric/bending_damping.hpp"
#include "sim/fabric/fabric.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace drape::sim::fabric {
namespace {

using namespace testing;

/// A sheet with one displaced vertex, so that two triangles are thin. @param fraction of a side [-]
std::shared_ptr<const ClothModel> sheetWithThinTriangles(const Material& material, double fraction = 0.95) {
  ClothMesh mesh = sheet(31);
  const Vec3 side = mesh.positions[1] - mesh.positions[0];
  mesh.positions[15 * 31 + 15] += fraction * side;
  return asFabric(*buildClothModel(mesh, 0.1, MassLumping::Area, {}), material);
}

TEST(RateLimit, leavesRatesBelowSixteenTimesTheMedianAlone) {
  std::vector<double> rates(200, 1.0);
  rates.back() = 1000.0;
  const RateLimit limit(rates, std::vector<double>(200, 1.0), 16.0);
  EXPECT_EQ(limit.scaleOf(1.0, 0), 1.0);
  EXPECT_EQ(limit.scaleOf(8.0, 0), 1.0);
  EXPECT_LT(limit.scaleOf(8.1, 0), 1.0);
  EXPECT_DOUBLE_EQ(limit.scaleOf(80.0, 0), 0.1);
}

TEST(RateLimit, leavesTheFastestHundredthAloneOfAMeshWithManySizes) {
  std::vector<double> rates;
  for (int i = 0; i < 1000; ++i) {
    rates.push_back(i < 900 ? 1.0 : 100.0);
  }
  EXPECT_EQ(RateLimit(rates, std::vector<double>(1000, 1.0), 16.0).scaleOf(50.0, 0), 1.0);
}

TEST(RateLimit, clampsNoTriangleOfAnEvenSheet) {
  const auto model = asFabric(*buildClothModel(sheet(31), 0.1, MassLumping::Area, {}), woven());
  EXPECT_EQ(model->fabric->slivers, 0);
}

TEST(RateLimit, keepsThinTrianglesFromDecidingTheTimeStep) {
  const auto even = asFabric(*buildClothModel(sheet(31), 0.1, MassLumping::Area, {}), membraneOnly());
  const auto thin = sheetWithThinTriangles(membraneOnly());
  EXPECT_GT(thin->fabric->slivers, 0);
  EXPECT_LT(thin->fabric->slivers, 20);
  EXPECT_LT(thin->unitFrequency, 6.0 * even->unitFrequency);
}

TEST(RateLimit, leavesTheBendingMatrixFreeOfRigidMotion) {
  const auto thin = sheetWithThinTriangles(woven());
  const VertexMatrix& bending = thin->fabric->bending;
  Eigen::MatrixXd linear(bending.rows(), 3);
  for (Eigen::Index v = 0; v < bending.rows(); ++v) {
    linear.row(v) << 1.0, thin->restPositions[static_cast<std::size_t>(v)].x(),
        thin->restPositions[static_cast<std::size_t>(v)].y();
  }
  EXPECT_LT((bending * linear).cwiseAbs().maxCoeff(), 1e-9 * bending.diagonal().maxCoeff());
}

TEST(TighterRateLimit, leavesAnEvenSheetAlone) {
  const auto even = asFabric(*buildClothModel(sheet(31), 0.1, MassLumping::Area, {}), woven());
  EXPECT_EQ(withTighterRateLimit(*even, 4.0), nullptr);
}

TEST(TighterRateLimit, softensOnlyTheSmallestTriangles) {
  const auto full = sheetWithThinTriangles(woven(), 0.8);
  ASSERT_EQ(full->fabric->slivers, 0);
  const auto limited = withTighterRateLimit(*full, 4.0);
  ASSERT_NE(limited, nullptr);
  EXPECT_GT(limited->fabric->slivers, 0);
  EXPECT_LT(limited->fabric->slivers, 20);
  EXPECT_LT(limited->unitFrequency, 0.95 * full->unitFrequency);
  EXPECT_NE(limited->fabric->fingerprint, full->fabric->fingerprint);
  EXPECT_EQ(limited->vertexMass, full->vertexMass);
  for (std::size_t t = 0; t < full->triangles.size(); ++t) {
    if (limited->fabric->membraneScales[t] == 1.0) {
      EXPECT_EQ(limited->fabric->membrane[t].stiffnessOfSides(), full->fabric->membrane[t].stiffnessOfSides());
    } else {
      EXPECT_LT(limited->fabric->membraneScales[t], 1.0);
    }
  }
}

TEST(TighterRateLimit, keepsThinTrianglesFromDecidingTheStagesOfDamping) {
  const auto even = asFabric(*buildClothModel(sheet(31), 0.1, MassLumping::Area, {}), woven());
  const auto thin = sheetWithThinTriangles(woven(), 0.97);
  EXPECT_LT(bendingDampingOf(*thin).highestRate, 20.0 * bendingDampingOf(*even).highestRate);
}

}  // namespace
}  // namespace drape::sim::fabric
