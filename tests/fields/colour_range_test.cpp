#include "fields/colour_range.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace drape::fields {
namespace {

const sim::fields::FieldInfo& speed() {
  return *sim::fields::findField("speed");
}

std::vector<double> upTo(double largest) {
  std::vector<double> values;
  for (int i = 0; i <= 1000; ++i) {
    values.push_back(largest * i / 1000.0);
  }
  return values;
}

TEST(ColourRange, RoundsUpToAFewNumbers) {
  EXPECT_DOUBLE_EQ(roundedUp(1.0), 1.0);
  EXPECT_DOUBLE_EQ(roundedUp(1.01), 1.5);
  EXPECT_DOUBLE_EQ(roundedUp(0.031), 0.04);
  EXPECT_DOUBLE_EQ(roundedUp(850.0), 1000.0);
  EXPECT_DOUBLE_EQ(roundedUp(3e-5), 3e-5);
}

TEST(ColourRange, CoversTheValuesExceptForFewExtremeOnes) {
  std::vector<double> values = upTo(2.9);
  values.push_back(1000.0);
  values.push_back(std::numeric_limits<double>::infinity());
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  AutomaticRange range;
  EXPECT_EQ(range.update(speed(), values, 0.0), (ColourRange{0.0, 3.0}));
}

TEST(ColourRange, BeginsAtTheNeutralValueOrSurroundsIt) {
  AutomaticRange stretch;
  EXPECT_EQ(stretch.update(*sim::fields::findField("strain_warp"), std::vector{90.0, 100.0, 118.0}, 0.0),
            (ColourRange{100.0, 120.0}));
  AutomaticRange curvature;
  EXPECT_EQ(curvature.update(*sim::fields::findField("bending"), std::vector{-18.0, 3.0}, 0.0),
            (ColourRange{-20.0, 20.0}));
}

TEST(ColourRange, DoesNotShowRounding) {
  AutomaticRange range;
  EXPECT_EQ(range.update(*sim::fields::findField("strain_warp"), std::vector{100.0, 100.0 + 1e-9}, 0.0),
            (ColourRange{100.0, 101.0}));
}

TEST(ColourRange, GrowsAtOnceAndShrinksAfterASecondOfSmallValues) {
  AutomaticRange range;
  range.update(speed(), upTo(1.0), 0.0);
  EXPECT_DOUBLE_EQ(range.update(speed(), upTo(4.0), 0.1).high, 4.0);
  double time = 0.2;
  for (; time < 1.0; time += 0.1) {
    EXPECT_DOUBLE_EQ(range.update(speed(), upTo(0.5), time).high, 4.0) << time;
  }
  for (; time < 3.0; time += 0.1) {
    range.update(speed(), upTo(0.5), time);
  }
  EXPECT_DOUBLE_EQ(range.update(speed(), upTo(0.5), time).high, 0.5);
}

TEST(ColourRange, StaysWhenValuesChangeALittle) {
  AutomaticRange range;
  const ColourRange first = range.update(speed(), upTo(2.9), 0.0);
  for (int i = 1; i < 100; ++i) {
    EXPECT_EQ(range.update(speed(), upTo(i % 2 == 0 ? 2.9 : 2.2), 0.1 * i), first);
  }
}

TEST(ColourRange, StartsAgainForAnotherFieldAndAfterAReset) {
  AutomaticRange range;
  range.update(speed(), upTo(50.0), 5.0);
  EXPECT_DOUBLE_EQ(range.update(speed(), upTo(1.0), 0.0).high, 1.0) << "time went back";
  EXPECT_DOUBLE_EQ(range.update(*sim::fields::findField("stress"), upTo(200.0), 0.1).high, 200.0);
}

TEST(ColourRange, IsDefinedWithoutAnyValue) {
  AutomaticRange range;
  EXPECT_LT(range.update(speed(), {}, 0.0).low, range.update(speed(), {}, 0.0).high);
}

}  // namespace
}  // namespace drape::fields
