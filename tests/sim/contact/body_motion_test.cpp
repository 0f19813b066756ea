#include "sim/contact/body_motion.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace drape {
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

TEST(BodyMotion, hasAVelocityThatDoesNotJumpAndRestsAtItsEnds) {
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
  EXPECT_LT((velocity(1.0) - Vec3(-1, 0, 4) / 2.5).norm(), 1e-3);  // the chord between its neighbours
}

TEST(BodyMotion, thatLoopsGoesOnWithoutAStop) {
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
}  // namespace drape
