#include "dressing/body_parts.hpp"
#include "shapes.hpp"
#include "sim/model/bounds.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <utility>

namespace drape::dressing::testing {
namespace {

/// The box of the vertices whose height in the full body is in a range [m].
Eigen::AlignedBox3d boxOf(const ShrinkingBody& body, std::size_t frame, double low, double high, double maxBeside) {
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < body.frames()[frame].size(); ++v) {
    const Vec3& full = body.frames().front()[v];
    if (full.y() > low && full.y() < high && std::abs(full.x()) < maxBeside) {
      box.extend(body.frames()[frame][v]);
    }
  }
  return box;
}

TEST(ShrinkingBody, turnsArmsIntoLinesBeforeTheTrunkIsThin) {
  const ShrinkingBody body(mannequin());
  const BodyParts parts(body);
  ASSERT_TRUE(parts.isPerson());
  const std::vector<Vec3>& lines = body.frames()[body.centreLines()];
  Eigen::AlignedBox3d slice;  // of the left upper arm
  for (std::size_t v = 0; v < lines.size(); ++v) {
    if (parts.ofVertex(static_cast<int>(v)) == BodyPart::LeftArm && std::abs(lines[v].x() - 0.30) < 0.01) {
      slice.extend(lines[v]);
    }
  }
  EXPECT_LT(slice.sizes().z(), 0.008);  // of 0.07 m
  const double trunk = boxOf(body, 0, 1.2, 1.25, 0.2).sizes().x();
  EXPECT_GT(boxOf(body, body.centreLines(), 1.2, 1.25, 0.2).sizes().x(), 0.5 * trunk);
  const double length = sim::boundsOf(body.frames().front()).sizes().x();
  EXPECT_GT(sim::boundsOf(lines).sizes().x(), 0.75 * length);
}

TEST(ShrinkingBody, growsAtABoundedSpeedToTheFullBody) {
  const ShrinkingBody body(ellipsoid({0.2, 0.5, 0.15}));
  const double speed = 0.3;
  const auto shape = body.growingFrom(body.thinnest(), speed);
  std::vector<Vec3> before;
  std::vector<Vec3> after;
  shape->deformation->positionsAt(0.0, before);
  EXPECT_EQ(before, body.frames().back());
  const double step = 0.01;
  const double end = body.wayTo(body.thinnest()) / speed;
  for (double time = step; time < end + step; time += step) {
    shape->deformation->positionsAt(time, after);
    for (std::size_t v = 0; v < after.size(); ++v) {
      ASSERT_LE((after[v] - before[v]).norm(), 1.0001 * speed * step) << time;
    }
    std::swap(before, after);
  }
  EXPECT_EQ(before, body.frames().front());
}

TEST(BodyParts, tellArmsHeadAndTrunkOfAMannequin) {
  const ShrinkingBody body(mannequin());
  const BodyParts parts(body);
  ASSERT_TRUE(parts.landmarks());
  const std::vector<Vec3>& full = body.frames().front();
  for (std::size_t v = 0; v < full.size(); ++v) {
    const BodyPart part = parts.ofVertex(static_cast<int>(v));
    if (full[v].x() > 0.25 && full[v].y() > 0.5) {
      EXPECT_EQ(part, BodyPart::LeftArm);
    } else if (full[v].x() < -0.25 && full[v].y() > 0.5) {
      EXPECT_EQ(part, BodyPart::RightArm);
    } else if (full[v].y() > 1.6) {
      EXPECT_EQ(part, BodyPart::Head);
    }
  }
  EXPECT_NEAR(parts.landmarks()->neck.y(), 1.42, 0.03);
  EXPECT_NEAR(parts.landmarks()->waist.y(), 1.06, 0.05);
  EXPECT_FALSE(parts.facesBack());
}

TEST(BodyParts, haveNoNamesOnAnEllipsoid) {
  const ShrinkingBody body(ellipsoid({0.3, 0.6, 0.2}));
  const BodyParts parts(body);
  EXPECT_FALSE(parts.isPerson());
  EXPECT_EQ(parts.ofVertex(0), BodyPart::Whole);
}

}  // namespace
}  // namespace drape::dressing::testing
