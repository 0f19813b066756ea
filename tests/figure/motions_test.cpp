#include "figure/motions.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <set>

namespace drape::figure {
namespace {

PerJoint<sim::contact::Pose> posesAt(const Motion& motion, double phase) {
  return jointPoses(restPlaces(), motion.pose(restPlaces(), phase));
}

/// The speed of the end of a joint's bone [m/s].
Vec3 velocityAt(const Motion& motion, std::size_t joint, double phase) {
  constexpr double step = 1e-5;
  const Vec3 bone = skeleton()[joint].end - skeleton()[joint].rest;
  const auto endAt = [&](double p) { return posesAt(motion, p - std::floor(p))[joint].toWorld(bone); };
  return (endAt(phase + step) - endAt(phase - step)) / (2.0 * step * motion.period);
}

TEST(Motions, haveDifferentNamesThatFindThem) {
  std::set<std::string_view> names;
  for (const Motion& motion : motions()) {
    EXPECT_TRUE(names.insert(motion.name).second) << motion.name;
    EXPECT_EQ(findMotion(motion.name), &motion);
    EXPECT_GT(motion.period, 0.0);
    EXPECT_NE(motionNames().find(motion.name), std::string::npos);
  }
  EXPECT_EQ(findMotion("fly"), nullptr);
}

TEST(Motions, loopWithAContinuousVelocity) {
  constexpr int samples = 2000;
  for (const Motion& motion : motions()) {
    for (const Joint joint : {Joint::Head, Joint::LeftHand, Joint::RightHand, Joint::LeftToes, Joint::RightToes}) {
      Vec3 before = velocityAt(motion, indexOf(joint), -0.5 / samples);
      double largest = 0.0;
      for (int k = 0; k < samples; ++k) {
        const Vec3 after = velocityAt(motion, indexOf(joint), (k + 0.5) / samples);
        largest = std::max(largest, (after - before).norm() / motion.period);
        before = after;
      }
      // A jump would have the size of the speed itself; an acceleration of 300 m/s^2 changes it by 0.15 m/s.
      EXPECT_LT(largest, 0.16) << motion.name << ", " << skeleton()[indexOf(joint)].name;
    }
  }
}

TEST(Motions, restInThePoseInWhichTheGarmentsAreFitted) {
  const auto poses = posesAt(*findMotion("rest"), 0.3);
  for (std::size_t j = 0; j < jointCount; ++j) {
    EXPECT_LT((poses[j].position - skeleton()[j].rest).norm(), 1e-12);
  }
}

TEST(Motions, holdTheArmsLevelInTheTPose) {
  const auto poses = posesAt(*findMotion("t_pose"), 0.0);
  const Vec3& shoulder = poses[indexOf(Joint::LeftUpperArm)].position;
  EXPECT_NEAR(poses[indexOf(Joint::LeftForearm)].position.y(), shoulder.y(), 0.01);
  EXPECT_NEAR(poses[indexOf(Joint::LeftHand)].position.y(), shoulder.y(), 0.01);
}

TEST(Motions, walkWithFeetThatDoNotSlideOnTheGround) {
  const Motion& walking = *findMotion("walk");
  const auto toes = indexOf(Joint::LeftToes);
  for (const double phase : {0.12, 0.2, 0.3, 0.4, 0.5}) {
    const auto poses = posesAt(walking, phase);
    EXPECT_NEAR(poses[toes].position.y(), restOf(Joint::LeftToes).y(), 0.002) << phase;
    const double later = posesAt(walking, phase + 0.01)[toes].position.z();
    EXPECT_NEAR((later - poses[toes].position.z()) / (0.01 * walking.period), -walking.pace, 1e-6) << phase;
  }
}

TEST(Motions, swingEachArmAgainstTheLegOfItsSideInTheWalk) {
  const auto poses = posesAt(*findMotion("walk"), 0.0);
  const auto z = [&](Joint joint) { return poses[indexOf(joint)].position.z(); };
  EXPECT_GT(z(Joint::LeftFoot), z(Joint::RightFoot) + 0.3);
  EXPECT_LT(z(Joint::LeftHand), z(Joint::RightHand) - 0.2);
  EXPECT_LT(poses[indexOf(Joint::LeftUpperArm)].position.z(), poses[indexOf(Joint::RightUpperArm)].position.z());
}

TEST(Motions, leaveTheFeetAboveTheGroundAndTheLegsAttached) {
  for (const Motion& motion : motions()) {
    for (int k = 0; k < 100; ++k) {
      const auto poses = posesAt(motion, k / 100.0);
      for (const Side side : {Side::Left, Side::Right}) {
        const auto ankle = indexOf(onSide(Joint::LeftFoot, side));
        EXPECT_GT(poses[ankle + 1].position.y(), 0.030) << motion.name << " at " << k;
        EXPECT_GT(poses[ankle].position.y(), 0.070) << motion.name << " at " << k;
      }
    }
  }
}

TEST(Motions, turnOnceInAPeriodOfTheTurn) {
  const Motion& turning = *findMotion("turn");
  const Vec3 quarter = posesAt(turning, 0.25)[0].rotation * Vec3::UnitZ();
  EXPECT_LT((quarter - Vec3::UnitX()).norm(), 1e-9);
}

}  // namespace
}  // namespace drape::figure
