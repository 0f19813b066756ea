#include "sim/fields/tension_field.hpp"
#include "fabric_cloths.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape::sim::fields {
namespace {

/// C of a stretch by these ratios along a direction and across it.
Eigen::Matrix2d metricFor(double along, double across, double angle) {
  const Vec2 n(std::cos(angle), std::sin(angle));
  const Vec2 m(-n.y(), n.x());
  return along * along * n * n.transpose() + across * across * m * m.transpose();
}

/// An isotropic sheet.
fabric::Material isotropic(double poisson) {
  fabric::Material material;
  material.stretchWarp = material.stretchWeft = 1000.0;
  material.shear = 500.0 * (1.0 - poisson);
  material.poisson = poisson;
  return material;
}

TEST(TensionField, ThePlainMaterialHasTheRatiosOfTheCloth) {
  const auto [stronger, weaker] = compressionsOf(metricFor(0.9, 1.05, 0.6), plainMaterial);
  EXPECT_NEAR(stronger.ratio, 0.9, 1e-12);
  EXPECT_NEAR(std::abs(stronger.along.dot(Vec2(std::cos(0.6), std::sin(0.6)))), 1.0, 1e-12);
  EXPECT_EQ(weaker.ratio, 1.0);
  const auto both = compressionsOf(metricFor(0.9, 0.95, 0.6), plainMaterial);
  EXPECT_NEAR(both[0].ratio, 0.9, 1e-12);
  EXPECT_NEAR(both[1].ratio, 0.95, 1e-12);
}

TEST(TensionField, ClothAtRestAndStretchedClothAreNotCompressed) {
  for (const fabric::Material& material : {plainMaterial, isotropic(0.3), testing::woven()}) {
    for (const auto& [along, across] : {std::pair(1.0, 1.0), std::pair(1.2, 1.1)}) {
      for (const Compression& compression : compressionsOf(metricFor(along, across, 0.0), material)) {
        EXPECT_NEAR(compression.ratio, 1.0, 1e-12);
      }
    }
  }
}

TEST(TensionField, ASheetContractsAcrossAStretchWithoutCompression) {
  constexpr double poisson = 0.3;
  const double stretch = 1.1;
  // Without stress across, Green's strain across is minus Poisson's ratio times that along.
  const double natural = std::sqrt(1.0 - poisson * (stretch * stretch - 1.0));
  const fabric::Material material = isotropic(poisson);
  EXPECT_NEAR(compressionsOf(metricFor(stretch, natural, 0.4), material)[0].ratio, 1.0, 1e-9);
  EXPECT_NEAR(compressionsOf(metricFor(stretch, 0.95 * natural, 0.4), material)[0].ratio, 0.95, 1e-9);
}

TEST(TensionField, YarnsThatTurnTowardsEachOtherAreHardlyCompressed) {
  fabric::Material woven = isotropic(0.0);
  woven.shear = 5.0;
  Eigen::Matrix2d sheared = Eigen::Matrix2d::Identity();
  sheared(0, 1) = sheared(1, 0) = std::sin(0.2);
  EXPECT_LT(compressionsOf(sheared, isotropic(0.0))[0].ratio, 0.92);
  EXPECT_GT(compressionsOf(sheared, woven)[0].ratio, 0.99);
}

TEST(TensionField, AStripBucklesLaterInShorterWaves) {
  const fabric::Material material = testing::woven();
  const double expected =
      4.0 * std::numbers::pi * std::numbers::pi / (0.05 * 0.05) * material.bendWarp / material.stretchWarp;
  EXPECT_NEAR(bucklingStrain(material, Vec2::UnitX(), 0.05), expected, 1e-12);
  EXPECT_NEAR(bucklingStrain(material, Vec2::UnitX(), 0.1), 0.25 * expected, 1e-12);
  EXPECT_NEAR(bucklingStrain(material, Vec2::UnitY(), 0.05),
              expected * material.bendWeft / material.bendWarp * material.stretchWarp / material.stretchWeft, 1e-12);
}

}  // namespace
}  // namespace drape::sim::fields
