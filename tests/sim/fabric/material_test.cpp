#include "sim/fabric/material.hpp"

#include "fabric_cloths.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape::sim::fabric {
namespace {

using testing::woven;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The bending stiffness along the direction at an angle from warp [N m].
double bendingAlong(const Material& material, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Vec3 kappa(c * c, s * s, 2.0 * c * s);  // of a cylinder with unit curvature along that direction
  return kappa.dot(bendMatrix(material) * kappa);
}

TEST(FabricMaterial, hasASymmetricPositiveDefiniteStiffness) {
  const Mat3 stretch = stretchMatrix(woven());
  EXPECT_EQ(stretch, stretch.transpose());
  EXPECT_GT(stretch.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
  EXPECT_DOUBLE_EQ(stretch(0, 1), 0.2 * std::sqrt(300.0 * 500.0));
}

TEST(FabricMaterial, bendsAlongWarpWeftAndBiasWithTheNamedStiffness) {
  const Material material = woven();
  EXPECT_NEAR(bendingAlong(material, 0.0), material.bendWarp, 1e-18);
  EXPECT_NEAR(bendingAlong(material, 0.5 * std::numbers::pi), material.bendWeft, 1e-18);
  EXPECT_NEAR(bendingAlong(material, 0.25 * std::numbers::pi), material.bendBias, 1e-18);
  EXPECT_NEAR(bendingAlong(material, -0.25 * std::numbers::pi), material.bendBias, 1e-18);
}

TEST(FabricMaterial, withOneBendingStiffnessBendsEquallyInAllDirections) {
  Material material;
  material.bendWarp = material.bendWeft = material.bendBias = 4e-5;
  for (double angle = 0.0; angle < 3.0; angle += 0.1) {
    EXPECT_NEAR(bendingAlong(material, angle), 4e-5, 1e-18) << angle;
  }
}

TEST(FabricMaterial, resistsBendingIfOneStiffnessIsNotZero) {
  EXPECT_FALSE(resistBending(Material{}));
  EXPECT_TRUE(resistBending(Material{.bendWarp = 1e-6}));
  EXPECT_TRUE(resistBending(Material{.bendWeft = 1e-6}));
  EXPECT_TRUE(resistBending(Material{.bendBias = 1e-6}));
}

TEST(FabricMaterial, isStableIfItsEnergyIsPositive) {
  EXPECT_TRUE(isStable(Material{}));
  EXPECT_TRUE(isStable(woven()));
  EXPECT_TRUE(isStable(testing::stiffeningFabric()));
}

TEST(FabricMaterial, isNotStableWithAModulusThatIsNegativeOrNotANumber) {
  for (double Material::*modulus : {&Material::stretchWarp, &Material::stretchWeft, &Material::shear,
                                    &Material::stiffeningWarp, &Material::stiffeningWeft, &Material::stiffeningStrain,
                                    &Material::bendWarp, &Material::bendWeft, &Material::bendBias}) {
    for (const double value : {-1e-3, notANumber}) {
      Material material = woven();
      material.*modulus = value;
      EXPECT_FALSE(isStable(material)) << value;
    }
  }
  for (double Material::*modulus :
       {&Material::stretchWarp, &Material::shear, &Material::stiffeningWarp, &Material::bendWeft}) {
    Material material = woven();
    material.*modulus = infinite;
    EXPECT_FALSE(isStable(material));
  }
}

TEST(FabricMaterial, isNotStableWithoutStretchOrShearStiffnessOrWithTooMuchContraction) {
  EXPECT_FALSE(isStable({.stretchWarp = 0.0}));
  EXPECT_FALSE(isStable({.shear = 0.0}));
  for (const double poisson : {-1.0, 1.0, 1.5, notANumber}) {
    EXPECT_FALSE(isStable({.poisson = poisson})) << poisson;
  }
  EXPECT_TRUE(isStable({.poisson = -0.99}));
}

TEST(FabricMaterial, isNotStableIfTheBiasBendsTooEasily) {
  // B_bias must exceed (B_1 + B_2) / 4, or twisting would release energy.
  EXPECT_FALSE(isStable({.bendWarp = 4e-5, .bendWeft = 4e-5, .bendBias = 1.9e-5}));
  EXPECT_TRUE(isStable({.bendWarp = 4e-5, .bendWeft = 4e-5, .bendBias = 2.1e-5}));
}

}  // namespace
}  // namespace drape::sim::fabric
