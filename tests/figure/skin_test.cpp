#include "figure/figure_pose.hpp"
#include "figure_mesh.hpp"
#include "sim/model/enclosed_volume.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>

namespace drape::figure {
namespace {

std::vector<Vec3> movedBy(const FigurePose& pose) {
  const BuiltFigure& figure = builtFigure();
  std::vector<Vec3> positions(figure.shape.positions.size());
  moveSkin(figure.shape.places, jointPoses(figure.shape.places, pose), figure.weights, figure.shape.positions,
           positions);
  return positions;
}

double volumeOf(const std::vector<Vec3>& positions) {
  return sim::enclosedVolume(positions, builtFigure().triangles);
}

TEST(Skin, hasWeightsThatAddUpToOne) {
  for (const SkinWeights& weights : builtFigure().weights) {
    EXPECT_NEAR(std::accumulate(weights.weights.begin(), weights.weights.end(), 0.0), 1.0, 1e-12);
    EXPECT_GE(weights.weights.back(), 0.0);
    EXPECT_TRUE(std::is_sorted(weights.weights.rbegin(), weights.weights.rend()));
  }
}

TEST(Skin, hasWeightsThatVarySmoothlyAlongTheSurface) {
  const BuiltFigure& figure = builtFigure();
  for (const Triangle& triangle : figure.triangles) {
    for (std::size_t j = 0; j < jointCount; ++j) {
      const auto joint = static_cast<Joint>(j);
      const double a = figure.weights[triangle[0]].of(joint);
      const double b = figure.weights[triangle[1]].of(joint);
      EXPECT_LT(std::abs(a - b), 0.35);
    }
  }
}

TEST(Skin, letsNoArmMoveTheTrunkBesideIt) {
  const BuiltFigure& figure = builtFigure();
  for (std::size_t v = 0; v < figure.weights.size(); ++v) {
    const Vec3& at = figure.shape.positions[v];
    if (std::abs(at.x()) < 0.18 && at.y() < 1.15) {
      EXPECT_EQ(figure.weights[v].of(Joint::LeftForearm) + figure.weights[v].of(Joint::RightForearm), 0.0);
      EXPECT_LT(figure.weights[v].of(Joint::LeftUpperArm) + figure.weights[v].of(Joint::RightUpperArm), 0.02);
    }
  }
}

TEST(Skin, movesRigidlyWithTheHips) {
  FigurePose pose;
  pose.shift = Vec3(0.3, -0.1, 0.2);
  pose.rotation(Joint::Hips) = turned(70.0, Vec3(1.0, 2.0, 3.0).normalized());
  const std::vector<Vec3> moved = movedBy(pose);
  const sim::contact::Pose hips{pose.rotation(Joint::Hips), restOf(Joint::Hips) + pose.shift};
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const Vec3 expected = hips.toWorld(builtFigure().shape.positions[v] - restOf(Joint::Hips));
    EXPECT_LT((moved[v] - expected).norm(), 1e-9);
  }
}

TEST(Skin, keepsItsVolumeWhenElbowsAndKneesBend) {
  FigurePose pose;
  for (const Joint joint : {Joint::LeftShin, Joint::RightShin}) {
    pose.rotation(joint) = turned(80.0, Vec3::UnitX());
  }
  pose.rotation(Joint::LeftForearm) = turned(70.0, Vec3(-0.6, -0.8, 0.0));
  EXPECT_NEAR(volumeOf(movedBy(pose)), volumeOf(builtFigure().shape.positions), 0.02 * volumeOf(movedBy({})));
}

TEST(Skin, acceptsEitherSignOfARotation) {
  FigurePose pose;
  pose.rotation(Joint::LeftForearm) = turned(40.0, Vec3::UnitY());
  const std::vector<Vec3> positive = movedBy(pose);
  pose.rotation(Joint::LeftForearm).coeffs() *= -1.0;
  const std::vector<Vec3> negative = movedBy(pose);
  for (std::size_t v = 0; v < positive.size(); ++v) {
    EXPECT_LT((positive[v] - negative[v]).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace drape::figure
