#include "sim/forces/kernels.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace drape::sim {
namespace {

constexpr double stiffness = 120.0;
constexpr double restLength = 0.5;

using testing::allDerivatives;

Mat3 differenceQuotient(const Vec3& offset) {
  constexpr double step = 1e-6;
  Mat3 derivative;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 nudge = step * Vec3::Unit(axis);
    derivative.col(axis) = (kernels::springForce(offset + nudge, restLength, stiffness) -
                            kernels::springForce(offset - nudge, restLength, stiffness)) /
                           (2.0 * step);
  }
  return derivative;
}

TEST(SpringDerivative, isTheForcesDerivativeWhereTheSpringIsStretched) {
  testing::RandomVectors random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 offset = random.next(1.0).normalized() * (restLength * (1.01 + 0.02 * i));
    const Mat3 difference = kernels::springDerivative(offset, restLength, stiffness) - differenceQuotient(offset);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-6 * stiffness);
  }
}

TEST(SpringDerivative, dropsOnlyTheNegativePartWhereTheSpringIsCompressed) {
  testing::RandomVectors random(2);
  for (int i = 1; i < 100; ++i) {
    const double length = restLength * 0.01 * i;
    const Vec3 offset = random.next(1.0).normalized() * length;
    const Mat3 dropped = stiffness * (1.0 - restLength / length) * Mat3::Identity();
    const Mat3 difference =
        kernels::springDerivative(offset, restLength, stiffness) + dropped - differenceQuotient(offset);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-4 * stiffness) << "at " << length << " m";
  }
}

TEST(SpringDerivative, isSymmetricAndPositiveSemiDefiniteAtAnyLength) {
  testing::RandomVectors random(3);
  for (int i = 0; i < 200; ++i) {
    const Mat3 J = kernels::springDerivative(random.next(1.2), restLength, stiffness);
    EXPECT_EQ(J, Mat3(J.transpose()));
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(J).eigenvalues().minCoeff(), -1e-12 * J.norm());
  }
}

/// The largest difference from the difference quotient, relative to the stiffness, over many directions.
double derivativeError(ForceDerivative variant, double length, const Mat3& projection) {
  testing::RandomVectors random(4);
  double largest = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 offset = random.next(1.0).normalized() * length;
    const Vec3 d = offset.normalized();
    const Mat3 along = d * d.transpose();
    // `projection` mixes the parts along and across the spring: its (0, 0) and (1, 1).
    const Mat3 kept = projection(0, 0) * along + projection(1, 1) * (Mat3::Identity() - along);
    const Mat3 difference =
        kernels::springDerivative(offset, restLength, stiffness, variant) - differenceQuotient(offset);
    largest = std::max(largest, (kept * difference).cwiseAbs().maxCoeff() / stiffness);
  }
  return largest;
}

const Mat3 alongAndAcross = Vec3(1.0, 1.0, 0.0).asDiagonal();
const Mat3 alongAlone = Vec3(1.0, 0.0, 0.0).asDiagonal();

TEST(SpringDerivativeVariants, areTheForcesDerivativeWhereTheySayThatTheyAre) {
  constexpr double stretched = 1.3 * restLength;
  constexpr double compressed = 0.7 * restLength;
  EXPECT_LT(derivativeError(ForceDerivative::Stabilised, stretched, alongAndAcross), 1e-6);
  EXPECT_LT(derivativeError(ForceDerivative::TensionOnly, stretched, alongAndAcross), 1e-6);
  for (const double length : {stretched, compressed}) {
    EXPECT_LT(derivativeError(ForceDerivative::Exact, length, alongAndAcross), 1e-6) << length;
    EXPECT_LT(derivativeError(ForceDerivative::Axial, length, alongAlone), 1e-6) << length;
    EXPECT_LT(derivativeError(ForceDerivative::Scalar, length, alongAlone), 1e-6) << length;
  }
}

TEST(SpringDerivativeVariants, areNotTheForcesDerivativeElsewhere) {
  constexpr double stretched = 1.3 * restLength;
  constexpr double compressed = 0.7 * restLength;
  EXPECT_GT(derivativeError(ForceDerivative::Stabilised, compressed, alongAlone), 0.1);
  EXPECT_GT(derivativeError(ForceDerivative::TensionOnly, compressed, alongAlone), 0.1);
  EXPECT_GT(derivativeError(ForceDerivative::Axial, stretched, alongAndAcross), 0.1);
  EXPECT_GT(derivativeError(ForceDerivative::Scalar, stretched, alongAndAcross), 0.1);
}

TEST(SpringDerivativeVariants, ofAScalarAreTheForcesDerivativeForASpringWithoutRestLength) {
  const Vec3 offset(0.3, -0.2, 0.5);
  const Mat3 exact = kernels::springDerivative(offset, 0.0, stiffness, ForceDerivative::Exact);
  const Mat3 scalar = kernels::springDerivative(offset, 0.0, stiffness, ForceDerivative::Scalar);
  EXPECT_LT((exact - scalar).cwiseAbs().maxCoeff(), 1e-12 * stiffness);
}

double smallestEigenvalue(const Mat3& J) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(J).eigenvalues().minCoeff();
}

TEST(SpringDerivativeVariants, areSymmetricAndAllButTheExactOneArePositiveSemiDefinite) {
  testing::RandomVectors random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 offset = random.next(1.0);
    for (const auto variant : allDerivatives) {
      const Mat3 J = kernels::springDerivative(offset, restLength, stiffness, variant);
      EXPECT_EQ(J, Mat3(J.transpose()));
      if (variant != ForceDerivative::Exact || offset.norm() > restLength) {
        EXPECT_GE(smallestEigenvalue(J), -1e-12 * stiffness) << static_cast<int>(variant) << " at " << offset.norm();
      }
    }
  }
}

TEST(SpringDerivativeVariants, ofTheExactKindAreIndefiniteUnderCompression) {
  testing::RandomVectors random(6);
  for (int i = 1; i < 100; ++i) {
    const double ratio = 0.01 * i;
    const Vec3 offset = random.next(1.0).normalized() * (ratio * restLength);
    const Mat3 J = kernels::springDerivative(offset, restLength, stiffness, ForceDerivative::Exact);
    EXPECT_NEAR(smallestEigenvalue(J), stiffness * (1.0 - 1.0 / ratio), 1e-9 * stiffness / ratio);
    EXPECT_LT(smallestEigenvalue(J), 0.0);
  }
}

TEST(SpringDerivativeVariants, areFiniteForASpringWithoutLength) {
  for (const auto variant : allDerivatives) {
    for (const double rest : {restLength, 0.0}) {
      EXPECT_TRUE(kernels::springDerivative(Vec3::Zero(), rest, stiffness, variant).allFinite());
    }
  }
}

TEST(SpringForce, vanishesForASpringWithoutLength) {
  EXPECT_EQ(kernels::springForce(Vec3::Zero(), restLength, stiffness), Vec3(Vec3::Zero()));
  EXPECT_TRUE(kernels::springDerivative(Vec3::Zero(), restLength, stiffness).allFinite());
}

TEST(Drag, pushesBackAlongTheVelocityOnly) {
  const Vec3 heading = Vec3(1.0, 2.0, -0.5).normalized();
  const Vec3 force = kernels::dragForce(Vec3(0.0, 0.6, 0.8), 3.0, heading, 0.2);
  EXPECT_LT(force.dot(heading), 0.0);
  EXPECT_LT(force.cross(heading).norm(), 1e-15);
}

TEST(Drag, equalsItsFormulaForASurfaceThatFacesTheWind) {
  const Vec3 force = kernels::dragForce(Vec3::UnitX(), 4.0, Vec3::UnitX(), 0.25);
  EXPECT_NEAR((force - Vec3(-4.0, 0.0, 0.0)).norm(), 0.0, 1e-15);
}

TEST(Lift, isAcrossTheVelocityAndTheSameFromEitherSide) {
  const Vec3 heading = Vec3(1.0, 0.3, 0.0).normalized();
  const Vec3 normal = Vec3(0.5, -1.0, 0.2).normalized();
  const Vec3 force = kernels::liftForce(normal, 2.0, heading, 0.1);
  EXPECT_NEAR(force.dot(heading), 0.0, 1e-15);
  EXPECT_NEAR((force - kernels::liftForce(-normal, 2.0, heading, 0.1)).norm(), 0.0, 1e-15);
  EXPECT_GT(force.norm(), 0.0);
}

TEST(RisingLift, isNoneWhereNeitherSideFacesTheWind) {
  EXPECT_EQ(kernels::risingLiftForce(Vec3::UnitY(), 2.0, Vec3::UnitX(), 0.1, 0.7).norm(), 0.0);
  EXPECT_EQ(kernels::risingLiftForce(-Vec3::UnitY(), 2.0, Vec3::UnitX(), 0.1, 0.7).norm(), 0.0);
}

TEST(RisingLift, growsFromNoneAsAThinPlatesAndBecomesTheLiftOfThePrint) {
  constexpr double speed = 3.0;
  constexpr double lift = 0.1;
  constexpr double rise = 0.7;
  for (const double incidence : {-0.5, -0.01, -1e-6, 1e-6, 0.02, 0.9}) {
    const Vec3 normal(incidence, std::sqrt(1.0 - incidence * incidence), 0.0);
    const Vec3 force = kernels::risingLiftForce(normal, speed, Vec3::UnitX(), lift, rise);
    const Vec3 printed = kernels::liftForce(normal, speed, Vec3::UnitX(), lift);
    EXPECT_NEAR(force.norm(), std::min(printed.norm(), rise * std::abs(incidence) * speed * speed), 1e-12) << incidence;
    EXPECT_LT(force.cross(printed).norm(), 1e-12) << "the same direction";
    EXPECT_GE(force.dot(printed), 0.0);
  }
}

TEST(Lift, raisesAPlateThatIsTiltedUpAgainstTheWind) {
  // The plate moves to +x with its leading edge up, so that its underside meets the air.
  const Vec3 underside = Vec3(1.0, -1.0, 0.0).normalized();
  EXPECT_GT(kernels::liftForce(underside, 5.0, Vec3::UnitX(), 0.1).y(), 0.0);
}

TEST(AirForce, neverReversesTheRelativeVelocityWithinAStep) {
  constexpr double mass = 1e-4;
  constexpr double timeStep = 1.0 / 30.0;
  testing::RandomVectors random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 velocity = random.next(1000.0);
    const Vec3 normal = random.next(1.0).normalized();
    for (const bool asPlate : {false, true}) {
      const Vec3 force = kernels::airForce(normal, velocity, {0.5, 0.5, 0.1}, asPlate, mass, timeStep);
      const Vec3 after = velocity + force * (timeStep / mass);
      EXPECT_GE(after.dot(velocity), -1e-9 * velocity.squaredNorm()) << asPlate;
    }
  }
}

TEST(AirForce, isThePlainFormulaInAGentleWind) {
  const Vec3 velocity(0.5, -1.0, 0.25);
  const Vec3 heading = velocity.normalized();
  const Vec3 normal = Vec3(0.1, 1.0, 0.3).normalized();
  const Vec3 expected = kernels::dragForce(normal, velocity.norm(), heading, 1e-3) +
                        kernels::liftForce(normal, velocity.norm(), heading, 2e-3);
  EXPECT_EQ(kernels::airForce(normal, velocity, {1e-3, 2e-3}, false, 1e-3, 1.0 / 150.0), expected);
}

TEST(PlateForce, hasTheCoefficientsOfDragAndLiftAtEveryAngleOfAttack) {
  const kernels::AirFactors factors{.drag = 1.2, .lift = 0.5, .edgeDrag = 0.1};
  for (double angle = -3.1; angle < 3.2; angle += 0.1) {  // of attack
    const Vec3 normal(std::sin(angle), std::cos(angle), 0.0);
    const Vec3 force = kernels::plateForce(normal, 2.0, Vec3::UnitX(), factors);
    const double sine = std::sin(angle);
    EXPECT_NEAR(force.x(), -4.0 * (0.1 + 1.1 * sine * sine), 1e-12) << angle;
    EXPECT_NEAR(force.y(), -4.0 * 0.5 * std::sin(2.0 * angle), 1e-12) << angle;
    EXPECT_NEAR(force.z(), 0.0, 1e-12) << angle;
    EXPECT_LT((force - kernels::plateForce(-normal, 2.0, Vec3::UnitX(), factors)).norm(), 1e-15) << "either side";
  }
}

TEST(PlateForce, raisesAPlateThatIsTiltedUpAgainstTheWind) {
  const Vec3 underside = Vec3(1.0, -1.0, 0.0).normalized();
  EXPECT_GT(kernels::plateForce(underside, 5.0, Vec3::UnitX(), {1.0, 0.5, 0.02}).y(), 0.0);
}

}  // namespace
}  // namespace drape::sim
