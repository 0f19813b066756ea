#include "sim/contact/bodies/motion.hpp"

#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape::sim::contact {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

BodyMotion unequalKeys() {
  BodyMotion motion;
  motion.keyframes = {{0.5, Vec3(0, 0, 0), Vec3(0, 0, 0)},
                      {1.0, Vec3(1, 2, -1), Vec3(0, 1, 0)},
                      {3.0, Vec3(-1, 0, 4), Vec3(0, turn + 1.0, 0)},
                      {3.5, Vec3(0, 0, 0), Vec3(0, 2.0 * turn, 0)}};
  return motion;
}

TEST(BodyMotion, withOneKeyframeStandsStill) {
  BodyMotion motion;
  motion.keyframes = {{0.0, Vec3(1, 2, 3), Vec3(0, 0, 0.5)}};
  EXPECT_FALSE(motion.moves());
  for (const double time : {-1.0, 0.0, 7.0}) {
    EXPECT_EQ(poseAt(motion, time).position, Vec3(1, 2, 3));
    EXPECT_NEAR(
        poseAt(motion, time).rotation.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitZ()))), 0.0,
        1e-7);
  }
}

TEST(BodyMotion, passesThroughItsKeyframes) {
  const BodyMotion motion = unequalKeys();
  EXPECT_TRUE(motion.moves());
  for (const Keyframe& key : motion.keyframes) {
    const Pose pose = poseAt(motion, key.time);
    EXPECT_LT((pose.position - key.position).norm(), 1e-14);
    EXPECT_NEAR(pose.rotation.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(key.rotation.y(), Vec3::UnitY()))),
                0.0, 1e-7);
  }
}

TEST(BodyMotion, hasAContinuousVelocityThatIsZeroAtItsEnds) {
  const BodyMotion motion = unequalKeys();
  constexpr double d = 1e-6;
  const auto velocity = [&](double time) -> Vec3 {
    return (poseAt(motion, time + d).position - poseAt(motion, time - d).position) / (2.0 * d);
  };
  for (const Keyframe& key : motion.keyframes) {
    EXPECT_LT((velocity(key.time + 2.0 * d) - velocity(key.time - 2.0 * d)).norm(), 2e-3) << key.time;
  }
  EXPECT_LT(velocity(0.5).norm(), 1e-3);
  EXPECT_LT(velocity(3.5).norm(), 1e-3);
  EXPECT_LT(velocity(1.0).norm(), 1e-3) << "all components turn back";
}

TEST(BodyMotion, isPlacedAfterAllOfIt) {
  const BodyMotion own = unequalKeys();
  BodyMotion placed = own;
  placed.spin = Vec3(0, 0.5, 0);
  placed.placement = poseOf(Vec3(0, 5, 0), Vec3(0, 0, 0.25 * turn));
  for (const double time : {0.0, 0.8, 2.0}) {
    BodyMotion spinning = own;
    spinning.spin = placed.spin;
    const Pose before = poseAt(spinning, time);
    const Pose after = poseAt(placed, time);
    EXPECT_LT((after.position - (Vec3(0, 5, 0) + Vec3(-before.position.y(), before.position.x(), before.position.z())))
                  .norm(),
              1e-12);
    EXPECT_LT(after.rotation.angularDistance(placed.placement->rotation * before.rotation), 1e-7);
  }
}

TEST(BodyMotion, loopsWithoutAStop) {
  BodyMotion motion = unequalKeys();
  motion.loop = true;
  constexpr double d = 1e-5;
  const Vec3 end = (poseAt(motion, 3.5 - d).position - poseAt(motion, 3.5 - 2.0 * d).position) / d;
  const Vec3 start = (poseAt(motion, 3.5 + 2.0 * d).position - poseAt(motion, 3.5 + d).position) / d;
  EXPECT_GT(end.norm(), 1.0);
  EXPECT_LT((end - start).norm(), 1e-2);
  for (const double time : {0.6, 1.7, 3.2}) {
    EXPECT_LT((poseAt(motion, time).position - poseAt(motion, time + 2.0 * 3.0).position).norm(), 1e-12);
    EXPECT_LT((poseAt(motion, time).position - poseAt(motion, time - 3.0).position).norm(), 1e-12);
  }
}

TEST(BodyMotion, hasTheVelocityOfTheChordLimitedToThreeTimesTheSlowerSide) {
  constexpr double d = 1e-6;
  BodyMotion motion;
  motion.keyframes = {{0.0, Vec3(0, 0, 0), Vec3(0, 0, 0)},
                      {1.0, Vec3(1, -1, 0.1), Vec3(2, 0, 0)},
                      {3.0, Vec3(5, -1.5, 8.1), Vec3(8, 0, 0)}};
  const Vec3 velocity = (poseAt(motion, 1.0 + d).position - poseAt(motion, 1.0 - d).position) / (2.0 * d);
  EXPECT_LT((velocity - Vec3(5.0 / 3.0, -0.5, 0.3)).norm(), 1e-4);
  const auto turned = poseAt(motion, 1.0 + d).rotation.angularDistance(poseAt(motion, 1.0 - d).rotation);
  EXPECT_NEAR(turned / (2.0 * d), 8.0 / 3.0, 1e-2);
}

/// Keyframes with a long motion, a rest and a short motion, for which unlimited cubic curves overshoot.
BodyMotion withARest() {
  BodyMotion motion;
  motion.keyframes = {{0.0, Vec3(0.3, 1.0, -2.0), Vec3(0, 0, 0)},
                      {1.0, Vec3(0.1, 0.4, -0.7), Vec3(0.3, 1.2, 0)},
                      {1.6, Vec3(0.1, 0.4, -0.7), Vec3(0.3, 1.2, 0)},
                      {1.9, Vec3(0.2, 0.5, -0.7), Vec3(0.4, -0.2, 0)},
                      {4.0, Vec3(0.3, 1.0, -2.0), Vec3(0, 0, 0)}};
  return motion;
}

TEST(BodyMotion, standsStillBetweenEqualKeyframes) {
  for (const bool loop : {false, true}) {
    BodyMotion motion = withARest();
    motion.loop = loop;
    const Pose there = poseAt(motion, 1.0);
    for (double time = 1.0; time <= 1.6; time += 0.013) {
      EXPECT_EQ(poseAt(motion, time).position, there.position) << time;
      EXPECT_EQ(poseAt(motion, time).rotation.coeffs(), there.rotation.coeffs()) << time;
    }
  }
}

TEST(BodyMotion, standsStillAcrossTheSeamOfALoop) {
  BodyMotion motion;
  motion.loop = true;
  motion.keyframes = {{0.0, Vec3(1, 0, 0), Vec3(0, 0, 0)},
                      {0.2, Vec3(1, 0, 0), Vec3(0, 0, 0)},
                      {1.0, Vec3(3, -1, 0), Vec3(0, 2, 0)},
                      {2.0, Vec3(1, 0, 0), Vec3(0, turn, 0)},
                      {2.3, Vec3(1, 0, 0), Vec3(0, turn, 0)}};
  for (double time = -0.3; time <= 0.2; time += 0.01) {
    const Pose pose = poseAt(motion, time);
    EXPECT_EQ(pose.position, Vec3(1, 0, 0)) << time;
    EXPECT_LT(pose.rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-7) << time;
  }
}

/// No component leaves the range of the two keyframes around it, whatever the times and values.
TEST(BodyMotion, neverOvershoots) {
  testing::RandomVectors random(11);
  for (const bool loop : {false, true}) {
    for (int round = 0; round < 50; ++round) {
      BodyMotion motion;
      motion.loop = loop;
      double time = 0.0;
      for (int k = 0; k < 6; ++k) {
        Vec3 position = random.next(1.0);
        position.z() = std::round(position.z());  // often equal to the one before
        motion.keyframes.push_back({time, position, Vec3::Zero()});
        time += 0.05 + std::abs(random.next(1.0).x());
      }
      motion.keyframes.back().position = motion.keyframes.front().position;
      for (std::size_t k = 0; k + 1 < motion.keyframes.size(); ++k) {
        const Keyframe& from = motion.keyframes[k];
        const Keyframe& to = motion.keyframes[k + 1];
        for (int i = 0; i <= 40; ++i) {
          const Vec3 position = poseAt(motion, from.time + i / 40.0 * (to.time - from.time)).position;
          EXPECT_TRUE((position.array() >= from.position.cwiseMin(to.position).array() - 1e-12).all());
          EXPECT_TRUE((position.array() <= from.position.cwiseMax(to.position).array() + 1e-12).all());
        }
      }
    }
  }
}

TEST(BodyMotion, spinsEvenly) {
  BodyMotion motion;
  motion.keyframes = {{0.0, Vec3(1, 0, 0), Vec3::Zero()}};
  motion.spin = Vec3(0.0, turn / 4.0, 0.0);
  EXPECT_TRUE(motion.moves());
  const Pose pose = poseAt(motion, 1.0);
  EXPECT_LT((pose.toWorld(Vec3(0, 0, 1)) - Vec3(2, 0, 0)).norm(), 1e-14);
  EXPECT_LT((pose.toLocal(pose.toWorld(Vec3(3, 2, 1))) - Vec3(3, 2, 1)).norm(), 1e-14);
  EXPECT_LT((poseAt(motion, 9.0).toWorld(Vec3(0, 0, 1)) - Vec3(2, 0, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace drape::sim::contact
