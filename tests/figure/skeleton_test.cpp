#include "figure/figure_pose.hpp"

#include <gtest/gtest.h>

namespace drape::figure {
namespace {

TEST(Skeleton, namesParentsBeforeTheirChildren) {
  for (std::size_t j = 1; j < jointCount; ++j) {
    EXPECT_LT(indexOf(skeleton()[j].parent), j) << skeleton()[j].name;
    EXPECT_GT(skeleton()[j].radius, 0.0) << skeleton()[j].name;
  }
}

TEST(Skeleton, isSymmetric) {
  for (std::size_t j = indexOf(Joint::LeftShoulder); j < jointCount; ++j) {
    const bool isLeft = skeleton()[j].name.starts_with("left");
    if (isLeft) {
      const auto left = static_cast<Joint>(j);
      const JointInfo& right = skeleton()[indexOf(onSide(left, Side::Right))];
      EXPECT_EQ(right.name.substr(6), skeleton()[j].name.substr(5));
      EXPECT_EQ(right.rest.x(), -skeleton()[j].rest.x());
      EXPECT_EQ(right.end.tail<2>(), skeleton()[j].end.tail<2>());
    }
  }
}

TEST(Skeleton, staysInTheRestPoseWithoutRotations) {
  const PerJoint<sim::contact::Pose> poses = jointPoses(restPlaces(), FigurePose{});
  for (std::size_t j = 0; j < jointCount; ++j) {
    EXPECT_LT((poses[j].position - skeleton()[j].rest).norm(), 1e-12);
    EXPECT_LT(poses[j].rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-12);
  }
}

TEST(Skeleton, carriesTheForearmWithTheUpperArm) {
  FigurePose pose;
  pose.rotation(Joint::LeftUpperArm) = turned(90.0, Vec3::UnitY());
  const PerJoint<sim::contact::Pose> poses = jointPoses(restPlaces(), pose);
  const Vec3 arm = restOf(Joint::LeftForearm) - restOf(Joint::LeftUpperArm);
  const Vec3 expected = restOf(Joint::LeftUpperArm) + Vec3(arm.z(), arm.y(), -arm.x());
  EXPECT_LT((poses[indexOf(Joint::LeftForearm)].position - expected).norm(), 1e-12);
  EXPECT_LT((poses[indexOf(Joint::RightForearm)].position - restOf(Joint::RightForearm)).norm(), 1e-12);
}

TEST(FigurePose, blendsHalfwayByHalfTheAngle) {
  FigurePose bent;
  bent.shift = Vec3(0.0, -0.2, 0.0);
  bent.rotation(Joint::LeftShin) = turned(80.0, Vec3::UnitX());
  FigurePose half = blended(FigurePose{}, bent, 0.5);
  EXPECT_EQ(half.shift.y(), -0.1);
  EXPECT_LT(half.rotation(Joint::LeftShin).angularDistance(turned(40.0, Vec3::UnitX())), 1e-12);
}

}  // namespace
}  // namespace drape::figure
