#include "sim/contact/constraints/primitive_search.hpp"

#include <gtest/gtest.h>

namespace drape::sim::contact {
namespace {

double gapTo(const BodyShape& shape, const Vec3& position) {
  Body body;
  body.shape = shape;
  const BodyStep step{&body, {}, {}, {}, {}, {}};
  return PrimitiveSearch(step, 0, ContactOffsets()).gapAt(position);
}

TEST(PrimitiveSearch, computesSignedDistancesToPrimitives) {
  EXPECT_DOUBLE_EQ(gapTo(PlaneShape{}, Vec3(3.0, 0.2, -1.0)), 0.2);
  EXPECT_DOUBLE_EQ(gapTo(PlaneShape{}, Vec3(3.0, -0.1, -1.0)), -0.1);
  EXPECT_DOUBLE_EQ(gapTo(SphereShape{0.5}, Vec3(0.0, 0.6, 0.8)), 0.5);
  EXPECT_DOUBLE_EQ(gapTo(SphereShape{0.5}, Vec3(0.25, 0.0, 0.0)), -0.25);
  const CapsuleShape capsule{0.1, 0.5};
  EXPECT_DOUBLE_EQ(gapTo(capsule, Vec3(0.0, 0.3, 0.3)), 0.2);         // beside its middle
  EXPECT_DOUBLE_EQ(gapTo(capsule, Vec3(0.3, 0.9, 0.0)), 0.5 - 0.1);   // above its end
  EXPECT_DOUBLE_EQ(gapTo(capsule, Vec3(0.0, -0.5, -0.025)), -0.075);  // in it
}

}  // namespace
}  // namespace drape::sim::contact
