#include "sim/forces/attachment.hpp"

#include "dense_cloth.hpp"

#include <gtest/gtest.h>
#include <array>
#include <memory>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

/// Saturated from 0.16 m on.
constexpr AttachmentSpring spring{.stiffness = 50.0, .maxForce = 8.0};

/// An offset below the bound of the force, one at it and two beyond.
const std::array<Vec3, 4> offsets{Vec3(0.05, -0.02, 0.1), Vec3(0.0, 0.16, 0.0), Vec3(0.1, 0.2, -0.1),
                                  Vec3(-3.0, 1.0, 20.0)};

TEST(AttachmentSpring, isLinearUpToItsBoundAndConstantBeyond) {
  EXPECT_NEAR(spring.force(Vec3(0.1, 0.0, 0.0)).x(), 5.0, 1e-12);
  EXPECT_NEAR(spring.force(Vec3(0.0, 1e9, 0.0)).norm(), 8.0, 1e-9);
  EXPECT_EQ(spring.force(Vec3::Zero()), Vec3(Vec3::Zero()));
}

TEST(AttachmentSpring, isSaturatedWhereTheLinearForceWouldExceedTheBound) {
  EXPECT_FALSE(spring.isSaturated(0.0));
  EXPECT_FALSE(spring.isSaturated(0.1599));
  EXPECT_TRUE(spring.isSaturated(0.1601));
  EXPECT_TRUE((AttachmentSpring{.stiffness = 50.0, .maxForce = 0.0}.isSaturated(1e-9)));
}

/// The trapezoidal rule is exact here: the force is linear between the points, and the bound begins at one of them.
TEST(AttachmentSpring, hasTheIntegralOfItsForceAsEnergy) {
  constexpr double step = 0.01;
  double integral = 0.0;
  for (int i = 0; i < 40; ++i) {
    EXPECT_NEAR(spring.energy(i * step), integral, 1e-12) << i * step << " m";
    integral += 0.5 * step * (spring.force(Vec3(i * step, 0, 0)).x() + spring.force(Vec3((i + 1) * step, 0, 0)).x());
  }
}

TEST(AttachmentSpring, hasTheDifferenceQuotientOfItsForceAsDerivative) {
  constexpr double step = 1e-6;
  for (const Vec3& offset : {offsets[0], offsets[2], offsets[3]}) {
    Mat3 quotient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 change = step * Vec3::Unit(axis);
      quotient.col(axis) = (spring.force(offset + change) - spring.force(offset - change)) / (2.0 * step);
    }
    EXPECT_LT((spring.forceDerivative(offset) - quotient).norm(), 1e-6) << offset.transpose();
  }
}

TEST(AttachmentSpring, hasASecantStiffnessThatGivesTheForce) {
  for (const Vec3& offset : offsets) {
    EXPECT_LT((spring.secantStiffness(offset) * offset - spring.force(offset)).norm(), 1e-12) << offset.transpose();
    EXPECT_LE(spring.secantStiffness(offset), spring.stiffness * (1.0 + 1e-15));
  }
  EXPECT_EQ(spring.secantStiffness(Vec3::Zero()), 50.0);
}

TEST(AttachmentSpring, hasAnImplicitImpulseThatSolvesItsEquationAndIsBounded) {
  constexpr double h = 0.01;
  constexpr double inverseMass = 300.0;
  const Vec3 impulse = spring.implicitImpulse(h, offsets[0], inverseMass);
  const Vec3 later = offsets[0] - 0.5 * h * inverseMass * impulse;
  EXPECT_LT((impulse - h * spring.stiffness * later).norm(), 1e-15);
  EXPECT_NEAR(spring.implicitImpulse(h, 1e6 * offsets[0], inverseMass).norm(), h * spring.maxForce, 1e-15);
  EXPECT_EQ(spring.implicitImpulse(h, Vec3::Zero(), inverseMass), Vec3(Vec3::Zero()));
}

/// A sheet in motion, and an attachment of triangle 9 to a target near its point.
class AttachedSheet : public ::testing::Test {
 protected:
  AttachedSheet() : model(unevenSheet(5, {0, 4})), state(shaken(*model, 0.05, 3)) {
    static_cast<AttachmentSpring&>(attachment) = spring;
    attachment.triangle = 9;
    attachment.barycentric = Vec3(0.2, 0.3, 0.5);
    attachment.target = point() + Vec3(0.05, -0.02, 0.1);
  }

  [[nodiscard]] AttachedCorners corners() const { return attachedCorners(*model, attachment); }
  [[nodiscard]] Vec3 point() const { return corners().interpolatedFrom(state.positions); }

  std::shared_ptr<const ClothModel> model;
  ClothState state;
  Attachment attachment;
};

TEST_F(AttachedSheet, hasCornersWhoseWeightsSumToOne) {
  double sum = 0.0;
  int count = 0;
  corners().forEach([&](std::size_t vertex, double weight) {
    EXPECT_EQ(static_cast<int>(vertex), model->triangles[9][static_cast<std::size_t>(count)]);
    EXPECT_EQ(corners().weightOf(vertex), weight);
    ++count;
    sum += weight;
  });
  EXPECT_EQ(count, 3);
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_EQ(corners().nearestVertex(), static_cast<std::size_t>(model->triangles[9][2]));
  EXPECT_EQ(corners().weightOf(0), std::nullopt) << "vertex 0 is not a corner of triangle 9";
}

TEST_F(AttachedSheet, interpolatesPositionsAndVelocitiesByTheWeights) {
  const Triangle& triangle = model->triangles[9];
  const auto at = [&](int corner) { return static_cast<std::size_t>(triangle[static_cast<std::size_t>(corner)]); };
  const auto& x = state.positions;
  EXPECT_LT((point() - (0.2 * x[at(0)] + 0.3 * x[at(1)] + 0.5 * x[at(2)])).norm(), 1e-15);
  const std::vector<Vec3> same(x.size(), Vec3(1.0, 2.0, 3.0));
  EXPECT_LT((corners().interpolatedFrom(same) - Vec3(1.0, 2.0, 3.0)).norm(), 1e-15);
  const Vec3 offset = corners().subtracted(attachment.target, [&](std::size_t v) { return x[v]; });
  EXPECT_LT((offset - (attachment.target - point())).norm(), 1e-15);
}

TEST_F(AttachedSheet, movesItsPointAsTheCornersMove) {
  ClothState after = state;
  for (std::size_t v = 0; v < after.positions.size(); ++v) {
    after.positions[v] += 0.1 * state.velocities[v];
  }
  const Vec3 velocity = corners().interpolatedFrom(state.velocities);
  EXPECT_GT(velocity.norm(), 1e-3);
  EXPECT_LT((attachedPointMotion(corners(), state, after) - 0.1 * velocity).norm(), 1e-15);
}

TEST_F(AttachedSheet, hasTheForceOfTheSpringAtItsPoint) {
  for (const Vec3& offset : offsets) {
    attachment.target = point() + offset;
    const AttachmentForce pull = attachmentForce(*model, attachment, state);
    EXPECT_LT((pull.force - spring.force(offset)).norm(), 1e-11) << offset.transpose();
    EXPECT_NEAR(pull.stiffness, spring.secantStiffness(offset), 1e-10);
    EXPECT_EQ(pull.velocity, corners().interpolatedFrom(state.velocities));
    EXPECT_EQ(pull.vertices, corners().vertices);
    EXPECT_EQ(pull.weights, attachment.barycentric);
  }
}

TEST_F(AttachedSheet, hasTheImplicitForceOfThePointThatMovedOn) {
  constexpr double h = 0.01;
  const AttachmentForce pull = attachmentForce(*model, attachment, state);
  const Vec3 later = attachment.target - point() - h * pull.velocity;
  ASSERT_FALSE(spring.isSaturated(later.norm()));
  EXPECT_LT((pull.implicitForce(h) - spring.force(later)).norm(), 1e-13);
}

TEST_F(AttachedSheet, distributesItsStiffnessOverTheDiagonalByTheWeights) {
  constexpr double h = 0.01;
  const AttachmentDiagonal diagonal = attachmentForce(*model, attachment, state).diagonal(h);
  EXPECT_EQ(diagonal.vertices, corners().vertices);
  EXPECT_LT((diagonal.additions - h * h * 50.0 * attachment.barycentric).norm(), 1e-16);
}

/// The sweeps of XPBD on the attachment alone: they reach the multiplier h^2 k (target - p) at the end, or its bound.
TEST_F(AttachedSheet, isAnXpbdConstraintWhoseMultiplierIsTheForce) {
  constexpr double h = 0.01;
  const Vec3 inverseMasses(0.0, 200.0, 100.0);  // the first corner is pinned
  for (const Vec3& start : offsets) {
    AttachmentConstraint constraint;
    Vec3 offset = start;
    Vec3 multiplier = Vec3::Zero();
    for (int sweep = 0; sweep < 3; ++sweep) {
      const auto moves = constraint.correct(attachment, corners(), h, offset, inverseMasses);
      EXPECT_EQ(moves[0], Vec3(Vec3::Zero()));
      offset -= 0.3 * moves[1] + 0.5 * moves[2];
      multiplier += moves[1] / (0.3 * 200.0);
      EXPECT_LT((moves[1] / (0.3 * 200.0) - moves[2] / (0.5 * 100.0)).norm(), 1e-15) << "momentum is conserved";
      EXPECT_LE(multiplier.norm(), h * h * spring.maxForce * (1.0 + 1e-12));
    }
    EXPECT_LT((multiplier - h * h * spring.force(offset)).norm(), 1e-14) << start.transpose();
  }
}

}  // namespace
}  // namespace drape::sim
