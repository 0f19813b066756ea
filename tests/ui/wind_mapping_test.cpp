#include "ui/wind_mapping.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

TEST(WindMapping, CalmIsTheCentre) {
  EXPECT_EQ(dialOffset(Vec3::Zero()), Vec2::Zero());
  EXPECT_EQ(windFromDial(Vec2::Zero()), Vec3::Zero());
}

TEST(WindMapping, RightIsXAndDownIsTowardsTheViewer) {
  EXPECT_GT(windFromDial({0.5, 0.0}).x(), 0.0);
  EXPECT_GT(windFromDial({0.0, 0.5}).z(), 0.0);
}

TEST(WindMapping, RoundTripKeepsTheWindToItsRounding) {
  const Vec3 wind(3.25, 0.0, -7.5);
  EXPECT_TRUE(windFromDial(dialOffset(wind)).isApprox(wind, 1e-3));
}

TEST(WindMapping, TheRimIsTheEnd) {
  EXPECT_DOUBLE_EQ(windFromDial({5.0, 0.0}).x(), dialSpeed);
  EXPECT_DOUBLE_EQ(dialOffset({90.0, 0.0, 0.0}).x(), 1.0);
}

TEST(WindMapping, RisingWindDoesNotMoveTheArrow) {
  EXPECT_EQ(dialOffset({0.0, 12.0, 0.0}), Vec2::Zero());
}

}  // namespace
}  // namespace drape::ui
