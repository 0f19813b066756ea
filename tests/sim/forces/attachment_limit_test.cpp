#include "sim/forces/attachment_limit.hpp"

#include "fabric_cloths.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

const Vec3 centre = Vec3::Constant(1.0 / 3.0);

/// A sheet of 1 m x 1 m with 5 x 5 vertices; triangle 10 lies inside of it.
std::shared_ptr<const ClothModel> sheetOf(double mass) {
  return buildClothModel(testing::sheet(5), mass, MassLumping::Uniform, {0, 4});
}

TEST(AttachmentLimit, isTheForceThatStretchesTheSpringsAroundAVertexByAFifth) {
  StepParameters parameters;
  parameters.material.stiffness = 80.0;
  // An inner vertex has four springs of 1/4 m and two of sqrt(2)/4 m.
  const double sum = 80.0 * (4.0 * 0.25 + 2.0 * 0.25 * std::sqrt(2.0));
  EXPECT_NEAR(maxAttachmentForce(*sheetOf(0.01), parameters, {10, Vec3(1, 0, 0)}), 0.2 * sum / 4.0, 1e-12);
}

TEST(AttachmentLimit, growsWithStiffnessAndWhereSeveralVerticesShareThePull) {
  const auto model = sheetOf(0.01);
  StepParameters parameters;
  const double force = maxAttachmentForce(*model, parameters, {10, centre});
  EXPECT_NEAR(force, 3.0 * maxAttachmentForce(*model, parameters, {10, Vec3(0, 1, 0)}), 1e-12);
  parameters.material.stiffness *= 7.0;
  EXPECT_NEAR(maxAttachmentForce(*model, parameters, {10, centre}), 7.0 * force, 1e-12);
}

TEST(AttachmentLimit, countsSpringsAsStiffAsTheyAre) {
  ClothModel model = *sheetOf(0.01);
  const StepParameters parameters;
  const double force = maxAttachmentForce(model, parameters, {10, centre});
  for (Spring& spring : model.springs) {
    spring.relativeStiffness = 3.0;
  }
  EXPECT_NEAR(maxAttachmentForce(model, parameters, {10, centre}), 3.0 * force, 1e-12);
}

TEST(AttachmentLimit, ofAFabricFollowsItsModuliAndNotTheSpringsStiffness) {
  StepParameters parameters;
  parameters.material.stiffness = 300.0;  // the smaller stretch modulus of the fabric
  const double ofSprings = maxAttachmentForce(*sheetOf(0.01), parameters, {10, centre});
  parameters.material.stiffness = 1.0;
  const auto model = testing::asFabric(*sheetOf(0.01), testing::woven());
  EXPECT_NEAR(maxAttachmentForce(*model, parameters, {10, centre}), ofSprings, 1e-12);
}

TEST(AttachmentLimit, isAQuarterOfTheWeightAtLeast) {
  StepParameters parameters;
  parameters.material.stiffness = 1.0;
  EXPECT_NEAR(maxAttachmentForce(*sheetOf(20.0), parameters, {10, centre}), 0.25 * 20.0 * 9.81, 1e-9);
  parameters.gravity = 0.0;
  EXPECT_GT(maxAttachmentForce(*sheetOf(20.0), parameters, {10, centre}), 0.0);
  EXPECT_LT(maxAttachmentForce(*sheetOf(20.0), parameters, {10, centre}), 1.0);
}

}  // namespace
}  // namespace drape::sim
