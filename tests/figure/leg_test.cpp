#include "figure/leg.hpp"

#include <gtest/gtest.h>

namespace drape::figure {
namespace {

Vec3 ballOf(const FigurePose& pose, Side side) {
  return jointPoses(restPlaces(), pose)[indexOf(onSide(Joint::LeftToes, side))].position;
}

TEST(Leg, putsTheBallOfTheFootWhereItIsWanted) {
  for (const Side side : {Side::Left, Side::Right}) {
    FigurePose pose;
    pose.shift = Vec3(0.02, -0.08, 0.01);
    pose.rotation(Joint::Hips) = turned(12.0, Vec3::UnitY());
    FootPlace foot;
    foot.ball = restOf(onSide(Joint::LeftToes, side)) + Vec3(0.03, 0.05, 0.2);
    foot.pitch = 20.0;
    foot.yaw = 8.0;
    placeFoot(restPlaces(), side, foot, pose);
    EXPECT_LT((ballOf(pose, side) - foot.ball).norm(), 1e-9);
  }
}

TEST(Leg, bendsTheKneeForward) {
  FigurePose pose;
  pose.shift = Vec3(0.0, -0.3, 0.0);
  FootPlace foot;
  foot.ball = restOf(Joint::LeftToes);
  placeFoot(restPlaces(), Side::Left, foot, pose);
  const auto poses = jointPoses(restPlaces(), pose);
  EXPECT_GT(poses[indexOf(Joint::LeftShin)].position.z(), restOf(Joint::LeftShin).z() + 0.15);
}

TEST(Leg, stretchesTowardsAPlaceOutOfReach) {
  FigurePose pose;
  FootPlace foot;
  foot.ball = restOf(Joint::LeftToes) - Vec3(0.0, 0.5, 0.0);
  placeFoot(restPlaces(), Side::Left, foot, pose);
  const auto poses = jointPoses(restPlaces(), pose);
  const Vec3 thigh = poses[indexOf(Joint::LeftShin)].position - poses[indexOf(Joint::LeftThigh)].position;
  const Vec3 shin = poses[indexOf(Joint::LeftFoot)].position - poses[indexOf(Joint::LeftShin)].position;
  EXPECT_GT(thigh.normalized().dot(shin.normalized()), 0.999);
}

}  // namespace
}  // namespace drape::figure
