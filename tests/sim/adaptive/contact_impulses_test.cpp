#include "sim/adaptive/contact_impulses.hpp"

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace drape::sim::adaptive {
namespace {

constexpr double drift = 0.01;  // [s]

/// A sheet of 3 x 3 vertices at the height 0 whose vertices move with one velocity. A contact acts after one drift.
class ContactImpulsesTest : public ::testing::Test {
 protected:
  /// Takes a drift with the contacts. @param gap height of the sheet above the contacts' height at its start [m]
  void take(const Vec3& velocity, double gap) { take(std::vector<Vec3>(model_->restPositions.size(), velocity), gap); }

  /// The same with a velocity for each vertex.
  void take(const std::vector<Vec3>& velocities, double gap) {
    simd::SlicedCloth<double> cloth(*model_);
    state_ = stateAtRest(model_->restPositions);
    state_.velocities = velocities;
    for (Vec3& each : state_.positions) {
      each.y() += gap;
    }
    const simd::StepShare share = simd::shareOf(cloth.layout, 1, 0, 1);
    cloth.prepare(1, 1);
    cloth.load(state_, share);
    StepInputs inputs;
    inputs.contacts = &contacts_;
    inputs.frameVelocity = frameVelocity_;
    impulses_.prepare(inputs, cloth);
    impulses_.start(cloth, share);
    simd::driftSlices(cloth, drift, share);
    impulses_.applySingle(cloth, drift, drift, share);
    impulses_.applyCoupled(cloth, drift, drift, share);
    impulses_.addWork(share);
    cloth.store(state_, share);
    impulses_.store(contacts_);
  }

  /// A contact of one vertex with a horizontal surface at the height 0.
  static SubstepContact onGround(int vertex) {
    return {.vertices = {vertex, vertex, vertex, vertex},
            .weights = {1.0, 0.0, 0.0, 0.0},
            .restGap = 1e-5,
            .staticFriction = 0.5,
            .kineticFriction = 0.4};
  }

  std::shared_ptr<const ClothModel> model_ = buildClothModel(testing::sheet(3), 0.9, MassLumping::Uniform, {8});
  double mass_ = model_->vertexMass[4];
  std::vector<SubstepContact> contacts_;
  Vec3 frameVelocity_ = Vec3::Zero();
  ContactImpulses<double> impulses_;
  ClothState state_;
};

TEST_F(ContactImpulsesTest, endAVertexOnTheSurfaceThatItWouldCross) {
  contacts_ = {onGround(4)};
  take(Vec3(0.0, -1.0, 0.0), 0.004);
  EXPECT_NEAR(state_.positions[4].y(), 0.0, 1e-12);
  EXPECT_NEAR(state_.velocities[4].y(), -0.4, 1e-12);
  EXPECT_NEAR(state_.positions[3].y(), 0.004 - 0.01, 1e-12);  // no contact
  EXPECT_NEAR(contacts_[0].impulse.y(), 0.6 * mass_, 1e-12);
}

TEST_F(ContactImpulsesTest, leaveAVertexAloneThatStaysAboveOrLeaves) {
  contacts_ = {onGround(4)};
  take(Vec3(0.3, -1.0, 0.0), 0.011);
  EXPECT_EQ(state_.velocities[4], Vec3(0.3, -1.0, 0.0));
  take(Vec3(0.3, 1.0, 0.0), 0.0);
  EXPECT_EQ(state_.velocities[4], Vec3(0.3, 1.0, 0.0));
  EXPECT_TRUE(contacts_[0].impulse.isZero(0.0));
}

TEST_F(ContactImpulsesTest, doNotPushOutAVertexThatStartsTooLow) {
  contacts_ = {onGround(4)};
  take(Vec3(0.0, -1.0, 0.0), -0.003);
  EXPECT_NEAR(state_.positions[4].y(), -0.003, 1e-12);
  EXPECT_NEAR(state_.velocities[4].y(), 0.0, 1e-12);
}

TEST_F(ContactImpulsesTest, stickBelowTheStaticCoefficientAndSlideAboveIt) {
  contacts_ = {onGround(4)};
  take(Vec3(0.49, -1.0, 0.0), 0.0);
  EXPECT_TRUE(state_.velocities[4].isZero(1e-12));
  take(Vec3(0.6, -1.0, 0.0), 0.0);
  EXPECT_NEAR(state_.velocities[4].x(), 0.6 - 0.4, 1e-12);
}

TEST_F(ContactImpulsesTest, followABodyThatMovesInAnyFrame) {
  contacts_ = {onGround(4)};
  contacts_[0].bodyVelocity = Vec3(0.2, 1.0, 0.0);
  take(Vec3::Zero(), 0.0);
  EXPECT_TRUE(state_.velocities[4].isApprox(Vec3(0.2, 1.0, 0.0), 1e-12));
  EXPECT_NEAR(state_.positions[4].y(), drift, 1e-12);
  frameVelocity_ = Vec3(0.2, 1.0, 0.0);
  take(Vec3::Zero(), 0.0);
  EXPECT_TRUE(state_.velocities[4].isZero(1e-12));
}

TEST_F(ContactImpulsesTest, actAtADistanceOnceOtherContactsHavePushedTheirVerticesThatFar) {
  const SubstepContact pair{
      .vertices = {1, 0, 0, 0}, .weights = {1.0, -1.0, 0.0, 0.0}, .height = -0.04, .restGap = 1e-5};
  SubstepContact pushed = onGround(0);
  pushed.bodyVelocity = Vec3(0.0, 10.0, 0.0);
  for (const std::vector<SubstepContact>& order : {std::vector{pair, pushed}, std::vector{pushed, pair}}) {
    contacts_ = order;
    take(Vec3::Zero(), 0.0);
    // Vertex 0 may approach vertex 1 by 0.04 m in a drift of 0.01 s, so vertex 1 must move at 10 - 4 m/s.
    EXPECT_NEAR(state_.velocities[0].y(), 10.0, 0.1);
    EXPECT_NEAR(state_.velocities[1].y(), 6.0, 0.2);
  }
}

TEST_F(ContactImpulsesTest, countTheWorkOnTheCloth) {
  contacts_ = {onGround(4)};
  take(Vec3(0.6, -1.0, 0.0), 0.0);
  const double kinetic = 0.5 * mass_ * (state_.velocities[4].squaredNorm() - 1.36);
  EXPECT_NEAR(impulses_.work(), kinetic, 1e-12);
  EXPECT_LT(kinetic, 0.0);
}

TEST_F(ContactImpulsesTest, stopAPointOfATriangleByMovingItsVertices) {
  contacts_ = {{.vertices = {0, 1, 4, 0}, .weights = {0.5, 0.25, 0.25, 0.0}, .restGap = 1e-5}};
  take(Vec3(0.0, -1.0, 0.0), 0.0);
  const auto& v = state_.velocities;
  EXPECT_NEAR(0.5 * v[0].y() + 0.25 * v[1].y() + 0.25 * v[4].y(), 0.0, 1e-12);
  EXPECT_NEAR((v[0].y() + 1.0) / (v[1].y() + 1.0), 2.0, 1e-9);  // all vertices have the same mass
}

TEST_F(ContactImpulsesTest, keepTheMomentumOfTwoPointsOfTheClothInContact) {
  contacts_ = {{.vertices = {0, 4, 0, 0},
                .weights = {1.0, -1.0, 0.0, 0.0},
                .normal = Vec3::UnitX(),
                .height = model_->restPositions[0].x() - model_->restPositions[4].x() + 0.01,
                .restGap = 1e-5,
                .staticFriction = 0.5,
                .kineticFriction = 0.4}};
  contacts_.push_back(contacts_[0]);
  contacts_[1].vertices[0] = 8;  // pinned
  contacts_[1].height = model_->restPositions[8].x() - model_->restPositions[4].x();
  take(Vec3(0.0, -1.0, 0.0), 0.0);
  EXPECT_NEAR((state_.velocities[0] + Vec3(0.0, 1.0, 0.0)).norm(), 0.0, 1e-12);  // both move alike
  contacts_.resize(1);
  contacts_[0].bodyVelocity = Vec3(0.5, 0.0, 0.0);  // as if they had to part at this speed
  take(Vec3(0.0, -1.0, 0.0), 0.0);
  const Vec3 sum = state_.velocities[0] + state_.velocities[4];
  EXPECT_TRUE(sum.isApprox(Vec3(0.0, -2.0, 0.0), 1e-12));
  EXPECT_NEAR(state_.velocities[0].x() - state_.velocities[4].x(), 0.5, 1e-12);
}

TEST_F(ContactImpulsesTest, satisfyTwoContactsOfOneVertexTogether) {
  contacts_ = {onGround(4), onGround(4)};
  contacts_[0].normal = Vec3(1.0, 1.0, 0.0).normalized();
  contacts_[1].normal = Vec3(-1.0, 1.0, 0.0).normalized();
  for (SubstepContact& contact : contacts_) {
    contact.height = contact.normal.dot(model_->restPositions[4]);
    contact.staticFriction = contact.kineticFriction = 0.0;
  }
  take(Vec3(0.0, -1.0, 0.0), 0.0);
  EXPECT_TRUE(state_.velocities[4].isZero(1e-9));  // a vertex in a groove
}

TEST_F(ContactImpulsesTest, limitTheSpeedOfAVertexThatBodiesSqueezeOut) {
  SubstepContact left = onGround(4);
  SubstepContact right = onGround(4);
  left.normal = Vec3(1.0, 0.2, 0.0).normalized();
  right.normal = Vec3(-1.0, 0.2, 0.0).normalized();
  left.bodyVelocity = Vec3(1.0, 0.0, 0.0);
  right.bodyVelocity = Vec3(-1.0, 0.0, 0.0);
  left.staticFriction = right.staticFriction = 0.0;
  left.kineticFriction = right.kineticFriction = 0.0;
  left.isFeaturePair = true;  // for more sweeps
  left.height = left.normal.dot(model_->restPositions[4]);
  right.height = right.normal.dot(model_->restPositions[4]);
  contacts_ = {left, right};
  take(Vec3::Zero(), 0.0);
  EXPECT_GT(state_.velocities[4].y(), 0.0);
  EXPECT_NEAR(state_.velocities[4].norm(), 3.0, 1e-12) << "three times the speed of the bodies";
}

TEST_F(ContactImpulsesTest, doNotLimitTheSpeedOfAVertexIfTheyTakeEnergy) {
  // Vertex 4 hits the middle of two others, one of which comes towards it.
  SubstepContact pair{
      .vertices = {4, 3, 5, 5}, .weights = {1.0, -0.5, -0.5, 0.0}, .restGap = 1e-5, .isFeaturePair = true};
  SubstepContact distant = onGround(5);
  distant.height = -1.0;
  distant.bodyVelocity = Vec3(0.1, 0.0, 0.0);
  contacts_ = {pair, distant};
  std::vector<Vec3> velocities(model_->restPositions.size(), Vec3::Zero());
  velocities[4].y() = -3.0;
  velocities[3].y() = -2.9;
  velocities[5].y() = 2.9;
  take(velocities, 0.0);
  EXPECT_NEAR(state_.velocities[4].y(), -1.0, 1e-12);
  EXPECT_NEAR(state_.velocities[3].y(), -3.9, 1e-12) << "faster than all vertices before";
  EXPECT_NEAR(state_.velocities[5].y(), 1.9, 1e-12);
}

TEST_F(ContactImpulsesTest, doNotDependOnContactsThatShareNoVertexWithThem) {
  const auto inGroove = [&](int vertex, double steepness) {
    for (const double side : {1.0, -1.0}) {
      SubstepContact contact = onGround(vertex);
      contact.normal = Vec3(side, steepness, 0.0).normalized();
      contact.height = contact.normal.dot(model_->restPositions[vertex]);
      contacts_.push_back(contact);
    }
  };
  inGroove(0, 1.5);
  take(Vec3(0.2, -1.0, 0.1), 0.0);
  const Vec3 alone = state_.velocities[0];
  EXPECT_GT(alone.norm(), 0.0);
  inGroove(4, 0.4);  // the narrower groove needs more sweeps
  take(Vec3(0.2, -1.0, 0.1), 0.0);
  EXPECT_EQ(state_.velocities[0], alone);
  contacts_.insert(contacts_.begin(), contacts_[3]);
  contacts_[0].vertices[0] = 4;
  take(Vec3(0.2, -1.0, 0.1), 0.0);
  EXPECT_EQ(state_.velocities[0], alone);
}

TEST_F(ContactImpulsesTest, doNothingToPinnedVertices) {
  contacts_ = {onGround(8)};
  take(Vec3(0.0, -1.0, 0.0), 0.0);
  EXPECT_EQ(impulses_.work(), 0.0);
  EXPECT_TRUE(contacts_[0].impulse.isZero(0.0));
}

}  // namespace
}  // namespace drape::sim::adaptive
