#include "sim/contact/bodies/substeps.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace drape::sim::contact {
namespace {

BodyStep turningStep() {
  BodyStep whole;
  whole.start.position = Vec3(0.0, 1.0, 0.0);
  whole.end.position = Vec3(0.4, 1.0, 0.8);
  whole.end.rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY());
  return whole;
}

TEST(BodySubsteps, keepExactlyThePoseOfABodyAtRest) {
  BodyStep whole;
  whole.start.position = whole.end.position = Vec3(-0.02, 0.1, 0.7);
  whole.start.rotation = whole.end.rotation = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized());
  BodySubsteps substeps;
  for (int part = 0; part < 7; ++part) {
    const BodyStep step = substeps.between({whole}, part / 7.0, (part + 1) / 7.0).front();
    EXPECT_EQ(step.start.position, whole.start.position) << part;
    EXPECT_EQ(step.end.position, whole.start.position) << part;
    EXPECT_EQ(step.start.rotation.coeffs(), whole.start.rotation.coeffs()) << part;
    EXPECT_EQ(step.end.rotation.coeffs(), whole.start.rotation.coeffs()) << part;
  }
}

TEST(BodySubsteps, connectExactlyToEachOtherAndToTheStep) {
  const std::vector<BodyStep> whole{turningStep()};
  BodySubsteps substeps;
  const Pose first = substeps.between(whole, 0.0, 1.0 / 3.0).front().start;
  EXPECT_EQ(first.position, whole.front().start.position);
  EXPECT_EQ(first.rotation.coeffs(), whole.front().start.rotation.coeffs());
  const Pose before = substeps.between(whole, 0.0, 1.0 / 3.0).front().end;
  const BodyStep last = substeps.between(whole, 1.0 / 3.0, 1.0).front();
  EXPECT_EQ(last.start.position, before.position);
  EXPECT_EQ(last.start.rotation.coeffs(), before.rotation.coeffs());
  EXPECT_EQ(last.end.position, whole.front().end.position);
  EXPECT_EQ(last.end.rotation.coeffs(), whole.front().end.rotation.coeffs());
}

TEST(BodySubsteps, translateAndRotateEvenly) {
  const std::vector<BodyStep> whole{turningStep()};
  BodySubsteps substeps;
  const Pose half = substeps.between(whole, 0.5, 1.0).front().start;
  EXPECT_LT((half.position - Vec3(0.2, 1.0, 0.4)).norm(), 1e-15);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()));
  EXPECT_LT(half.rotation.angularDistance(turn), 1e-12);
}

TEST(BodySubsteps, interpolateVerticesOfADeformingMesh) {
  const std::vector<Vec3> start{Vec3::Zero(), Vec3::UnitX()};
  const std::vector<Vec3> end{Vec3::Zero(), Vec3(1.0, 0.8, 0.0)};
  BodyStep deforming = turningStep();
  deforming.startVertices = start;
  deforming.endVertices = end;
  BodyStep rigid = turningStep();
  rigid.startVertices = start;
  rigid.endVertices = start;
  const std::vector<BodyStep> whole{deforming, rigid};
  BodySubsteps substeps;
  const std::vector<BodyStep>& quarter = substeps.between(whole, 0.25, 0.5);
  EXPECT_LT((quarter[0].startVertices[1] - Vec3(1.0, 0.2, 0.0)).norm(), 1e-15);
  EXPECT_LT((quarter[0].endVertices[1] - Vec3(1.0, 0.4, 0.0)).norm(), 1e-15);
  EXPECT_EQ(quarter[1].startVertices.data(), start.data()) << "a rigid mesh keeps its vertices";
}

}  // namespace
}  // namespace drape::sim::contact
