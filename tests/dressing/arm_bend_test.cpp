#include "dressing/arm_bend.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>

namespace drape::dressing::testing {
namespace {

TEST(ArmBend, turnsTheCentreLinesOfTheArmsToTheSleevesAndLeavesTheFullBody) {
  const ShrinkingBody body(mannequin());
  const BodyParts parts(body);
  const sim::ClothMesh lowered = shifted(tshirt(), {0.0, -0.08, 0.0});
  const GarmentOpenings openings(lowered);
  ArmBend bend(body, parts);
  bend.aim(openings, lowered.positions);
  EXPECT_EQ(bend.bent(0), body.frames().front());
  const Vec3& sleeve = openings.find(OpeningKind::LeftSleeve)->centre;
  const auto distance = [&](const std::vector<Vec3>& positions) {
    double min = std::numeric_limits<double>::max();
    for (const Vec3& position : positions) {
      min = std::min(min, (position - sleeve).norm());
    }
    return min;
  };
  EXPECT_GT(distance(body.frames()[body.centreLines()]), 0.05);
  EXPECT_LT(distance(bend.bent(body.centreLines())), 0.015);
}

TEST(ArmBend, leavesABodyWithoutArms) {
  const ShrinkingBody body(ellipsoid({0.3, 0.6, 0.2}));
  const BodyParts parts(body);
  ArmBend bend(body, parts);
  bend.aim(GarmentOpenings(tshirt()), tshirt().positions);
  EXPECT_EQ(bend.bent(body.thinnest()), body.frames().back());
}

}  // namespace
}  // namespace drape::dressing::testing
