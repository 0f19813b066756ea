#include "report/validation/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drape::report::validation {
namespace {

TEST(HeavyElastica, dropsByAnEighthOfASmallGamma) {
  for (const double gamma : {1e-4, 1e-3, 1e-2}) {
    const ElasticaTip tip = heavyElasticaTip(gamma);
    EXPECT_NEAR(tip.down, gamma / 8.0, 1e-4 * gamma / 8.0);
    EXPECT_NEAR(tip.along, 1.0, gamma);
  }
}

TEST(HeavyElastica, shortensByHalfTheSquaredSlope) {
  // The slope of the beam is Gamma (s - s^2 + s^3 / 3) / 2; the integral of its squared half over s is Gamma^2 / 112.
  const double gamma = 0.1;
  EXPECT_NEAR(1.0 - heavyElasticaTip(gamma).along, gamma * gamma / 112.0, 1e-3 * gamma * gamma / 112.0);
}

TEST(HeavyElastica, hangsStraightDownIfItIsVeryHeavy) {
  // Near the clamp the bend has the length (B / (w L))^(1/2), which falls with Gamma^(-1/2).
  const ElasticaTip tip = heavyElasticaTip(400.0);
  EXPECT_GT(tip.down, 0.94);
  EXPECT_LT(tip.along, 0.1);
  EXPECT_GT(tip.along, 0.0);
}

TEST(HeavyElastica, dropsMoreTheHeavierItIs) {
  double former = 0.0;
  for (const double gamma : {0.5, 1.5, 5.0, 15.0, 46.0, 100.0}) {
    const ElasticaTip tip = heavyElasticaTip(gamma);
    EXPECT_GT(tip.down, former);
    EXPECT_LT(std::hypot(tip.down, tip.along), 1.0);
    former = tip.down;
  }
}

TEST(HeavyElastica, hasTheGammaOfItsChord) {
  for (const double angle : {0.1, 0.5, peirceAngle, 1.2}) {
    EXPECT_NEAR(heavyElasticaTip(gammaOfChordAngle(angle)).chordAngle(), angle, 1e-10);
  }
}

TEST(Peirce, approximatesTheElasticaWithinAFewPercent) {
  constexpr double bending = 5e-5;  // [N m]
  constexpr double weight = 2.0;    // [N/m^2]
  const double overhang = peirceOverhang(bending, weight);
  EXPECT_NEAR(peirceFormula(overhang, peirceAngle), bendingLength(bending, weight),
              0.04 * bendingLength(bending, weight));
}

TEST(Peirce, bendingLengthIsHalfTheOverhangAt41Point5Degrees) {
  EXPECT_NEAR(peirceFormula(1.0, peirceAngle), 0.5, 0.01);
  EXPECT_DOUBLE_EQ(bendingLength(8e-6, 1.0), 0.02);
}

TEST(Stretch, fulfilsTheLaw) {
  for (const double force : {0.0, 1e-3, 1.0, 50.0, 3000.0}) {
    const double stretch = stretchUnderLoad(force, 1000.0);
    EXPECT_NEAR(500.0 * stretch * (stretch * stretch - 1.0), force, 1e-10 * (1.0 + force));
  }
}

TEST(Stretch, isHookesForSmallForces) {
  const double stretch = stretchUnderLoad(1e-3, 1000.0);
  EXPECT_NEAR(stretch - 1.0, 1e-6, 1e-11);
  EXPECT_NEAR(1.0 - stretchAcross(stretch, 0.3), 0.3e-6, 1e-11);
}

TEST(ElongationByWeight, isHalfThatOfTheSameEndLoadForSmallWeights) {
  EXPECT_NEAR(elongationByWeight(1.0, 0.2, 1e4), 1.0 * 0.2 * 0.2 / (2.0 * 1e4), 1e-10);
}

TEST(ElongationByWeight, isTheSumOfThatOfItsParts) {
  constexpr double weight = 300.0;
  constexpr double length = 0.4;
  constexpr double modulus = 500.0;
  constexpr int parts = 2000;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double force = weight * length * (i + 0.5) / parts;
    sum += (stretchUnderLoad(force, modulus) - 1.0) * length / parts;
  }
  EXPECT_NEAR(elongationByWeight(weight, length, modulus), sum, 1e-7 * sum);
}

TEST(Catenary, ofSmallSagIsAParabola) {
  // The length of a flat parabola is span (1 + 8/3 (sag / span)^2).
  constexpr double sag = 0.01;
  EXPECT_NEAR(catenarySag(1.0 + 8.0 / 3.0 * sag * sag, 1.0), sag, 1e-3 * sag);
}

TEST(Catenary, fulfilsTheRelationOfLengthAndSag) {
  // For a catenary of parameter a: (L / 2)^2 = sag^2 + 2 a sag, and cosh(span / (2 a)) = 1 + sag / a.
  for (const double span : {0.2, 0.5, 0.8, 0.99}) {
    const double sag = catenarySag(1.0, span);
    const double a = (0.25 - sag * sag) / (2.0 * sag);
    EXPECT_NEAR(std::cosh(0.5 * span / a), 1.0 + sag / a, 1e-8 * (1.0 + sag / a)) << span;
  }
}

TEST(Catenary, ofNearbySupportsHangsByHalfItsLength) {
  EXPECT_NEAR(catenarySag(1.0, 1e-3), 0.5, 5e-3);
}

TEST(Buckling, loadFallsWithTheSquareOfTheLength) {
  EXPECT_NEAR(bucklingLoad(1e-4, 0.2), 0.024674011, 1e-9);
  EXPECT_NEAR(bucklingLoad(1e-4, 0.1) / bucklingLoad(1e-4, 0.2), 4.0, 1e-12);
}

TEST(Shear, ofAFrameAndOfASheetAreTheSameForSmallAngles) {
  sim::fabric::Material material;
  const double linear = 0.5 * material.shear * 1e-6;
  EXPECT_NEAR(pictureFrameEnergy(material, 1e-3), linear, 1e-5 * linear);
  EXPECT_NEAR(simpleShearEnergy(material, 1e-3), linear, 1e-4 * linear);
  EXPECT_GT(simpleShearEnergy(material, 0.5), 0.5 * material.shear * 0.25);
}

TEST(Shear, ofAFrameIsLargestAtARightAngle) {
  sim::fabric::Material material;
  EXPECT_NEAR(pictureFrameEnergy(material, 0.5 * std::numbers::pi), 0.5 * material.shear, 1e-12);
}

TEST(Bias, modulusOfAnIsotropicSheetIsItsYoungsModulus) {
  constexpr double poisson = 0.3;
  const sim::fabric::Material material{.stretchWarp = 1000.0 / (1.0 - poisson * poisson),
                                       .stretchWeft = 1000.0 / (1.0 - poisson * poisson),
                                       .shear = 500.0 / (1.0 + poisson),
                                       .poisson = poisson};
  EXPECT_NEAR(biasModulus(material), 1000.0, 1e-9);
}

TEST(Bias, modulusOfAFabricThatHardlyResistsShearIsFourTimesTheShearModulus) {
  EXPECT_NEAR(biasModulus({.stretchWarp = 1e6, .stretchWeft = 1e6, .shear = 10.0}), 40.0, 0.01);
}

TEST(MembraneFrequency, isThatOfAStringForASmallStretch) {
  // A string of tension T and mass per length m has sqrt(T / m) / (2 L); a wave across a square has sqrt(2) of it.
  constexpr double strain = 1e-4;
  EXPECT_NEAR(membraneFrequency(1000.0, 1.0 + strain, 0.2, 0.5, 1, 1),
              std::sqrt(2.0) * std::sqrt(1000.0 * strain / 0.2) / (2.0 * 0.5), 1e-3);
  EXPECT_NEAR(membraneFrequency(1000.0, 1.1, 0.2, 0.5, 2, 2) / membraneFrequency(1000.0, 1.1, 0.2, 0.5, 1, 1), 2.0,
              1e-12);
}

TEST(CantileverFrequency, isNearThatOfRayleighsQuotientAndBelowIt) {
  // Of the shape s^2 the quotient is 4 B L / (m L^5 / 5) = 20 B / (m L^4).
  const double upper = std::sqrt(20.0 * 1e-4 / 0.05) / (2.0 * std::numbers::pi * 0.2 * 0.2);
  const double frequency = cantileverFrequency(1e-4, 0.05, 0.2);
  EXPECT_LT(frequency, upper);
  EXPECT_GT(frequency, 0.78 * upper);
}

TEST(CantileverFrequency, belongsToItsModeByRayleighsQuotient) {
  constexpr int parts = 2000;
  double bend = 0.0;
  double mass = 0.0;
  for (int i = 1; i < parts; ++i) {
    const double at = static_cast<double>(i) / parts;
    const double curvature = (cantileverMode(at + 1e-3) - 2.0 * cantileverMode(at) + cantileverMode(at - 1e-3)) / 1e-6;
    bend += curvature * curvature / parts;
    mass += cantileverMode(at) * cantileverMode(at) / parts;
  }
  EXPECT_NEAR(std::sqrt(bend / mass) / (2.0 * std::numbers::pi), cantileverFrequency(1.0, 1.0, 1.0), 0.002);
  EXPECT_NEAR(cantileverMode(1.0), 1.0, 1e-12);
  EXPECT_NEAR(cantileverMode(0.0), 0.0, 1e-12);
}

TEST(Incline, accelerationVanishesAtTheSlopeOfFrictionAndIsThatOfAFreeFallOnACliff) {
  EXPECT_NEAR(slidingAcceleration(0.4, 0.4, 9.81), 0.0, 1e-12);
  EXPECT_NEAR(slidingAcceleration(1e6, 0.4, 9.81), 9.81, 1e-4);
  EXPECT_NEAR(slidingAcceleration(0.75, 0.0, 10.0), 6.0, 1e-12);
}

TEST(TerminalFall, fallsFreelyAtFirstAndEvenlyAtTheEnd) {
  const double speed = terminalSpeed(0.1, 1.225, 1.2, 9.81);
  EXPECT_NEAR(0.5 * 1.225 * 1.2 * speed * speed, 0.1 * 9.81, 1e-12);
  const TerminalFall fall{.speed = speed, .gravity = 9.81};
  EXPECT_NEAR(fall.distance(1e-3), 0.5 * 9.81 * 1e-6, 1e-10);
  EXPECT_NEAR(fall.distance(3.0) - fall.distance(2.0), speed, 1e-6);
}

/// theta = sqrt(s) J_(-1/6)(k s^3 / 3), as a power series without constant factors.
double twistAtTheClamp(double k) {
  double term = 1.0;
  double sum = 1.0;
  for (int m = 1; m < 40; ++m) {
    term *= -k * k / 36.0 / (m * (m - 1.0 / 6.0));
    sum += term;
  }
  return sum;
}

TEST(LateralBuckling, hasTheFirstZeroOfABesselFunctionWithoutWarping) {
  const double number = lateralBucklingNumber(0.0);
  EXPECT_NEAR(number, 12.85, 0.01);
  EXPECT_GT(twistAtTheClamp(0.5 * number - 1e-4), 0.0);
  EXPECT_LT(twistAtTheClamp(0.5 * number + 1e-4), 0.0);
}

TEST(LateralBuckling, isHinderedByWarpingInALayerAtTheClamp) {
  const double without = lateralBucklingNumber(0.0);
  const double narrow = lateralBucklingNumber(1e-4) / without - 1.0;
  const double wide = lateralBucklingNumber(4e-4) / without - 1.0;
  EXPECT_GT(narrow, 0.0);
  EXPECT_NEAR(wide / narrow, 2.0, 0.15);  // the layer has the length sqrt(warping)
}

TEST(LateralBuckling, weightFallsWithTheThirdPowerOfTheLength) {
  const double weight = lateralBucklingWeight(1e-4, 0.5e-4, 0.01, 0.2);
  EXPECT_NEAR(lateralBucklingWeight(1e-4, 0.5e-4, 0.02, 0.4) / weight, 0.125, 1e-9);
  EXPECT_NEAR(lateralBucklingWeight(2e-4, 1e-4, 0.01, 0.2) / weight, 2.0, 1e-9);
  // A narrow strip: 12.85 sqrt(B C) / (b L^3) with B = D_11 b and C = 4 D_33 b.
  EXPECT_NEAR(lateralBucklingWeight(1e-4, 0.5e-4, 1e-4, 0.2), 12.85 * std::sqrt(2e-8) / 0.008, 0.01 * weight);
}

TEST(PressedStrip, needsAFrictionThatRisesWithTheRootOfASmallShortening) {
  // Small deflections: q / p = 2 sqrt(shortening) / k with k = tan(k).
  for (const double shortening : {1e-4, 1e-3}) {
    EXPECT_NEAR(frictionOfPressedStrip(shortening), 2.0 * std::sqrt(shortening) / 4.4934095,
                2e-3 * std::sqrt(shortening));
  }
}

TEST(PressedStrip, needsMoreFrictionTheMoreItIsPressed) {
  double former = 0.0;
  for (const double shortening : {0.05, 0.1, 0.2, 0.3, 0.5}) {
    EXPECT_GT(frictionOfPressedStrip(shortening), former);
    former = frictionOfPressedStrip(shortening);
  }
  EXPECT_LT(former, 1.0);
}

}  // namespace
}  // namespace drape::report::validation
