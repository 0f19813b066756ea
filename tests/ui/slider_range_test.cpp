#include "ui/slider_range.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

TEST(SliderRange, EverySliderHoldsItsDefaultAndStaysInRange) {
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    if (const auto* field = std::get_if<settings::NumberField>(&info.field)) {
      const double usual = std::get<double>(settings::defaultValue(info));
      const SliderRange range = commonRange(*field, usual);
      EXPECT_LT(range.min, range.max) << info.key;
      EXPECT_GE(range.min, field->min) << info.key;
      EXPECT_LE(range.max, field->max) << info.key;
      EXPECT_GE(usual, range.min) << info.key;
      EXPECT_LE(usual, range.max) << info.key;
    }
  }
}

TEST(SliderRange, ValueAndFractionAreInverse) {
  const SliderRange linear{-20.0, 20.0, false};
  const SliderRange decades{1e-5, 0.1, true};
  const SliderRange fromZero{0.0, 100.0, true};
  for (const double place : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(sliderFraction(linear, sliderValue(linear, place)), place, 1e-12);
    EXPECT_NEAR(sliderFraction(decades, sliderValue(decades, place)), place, 1e-12);
    EXPECT_NEAR(sliderFraction(fromZero, sliderValue(fromZero, place)), place, 1e-12);
  }
}

TEST(SliderRange, EndsAreReached) {
  const SliderRange fromZero{0.0, 100.0, true};
  EXPECT_EQ(sliderValue(fromZero, 0.0), 0.0);
  EXPECT_EQ(sliderValue(fromZero, 1.0), 100.0);
  EXPECT_EQ(sliderValue(fromZero, 1.7), 100.0);
  EXPECT_EQ(sliderValue(fromZero, -3.0), 0.0);
}

TEST(SliderRange, ValuesBeyondTheSliderSitAtItsEnd) {
  const SliderRange range{0.0, 6.0, false};
  EXPECT_EQ(sliderFraction(range, 1000.0), 1.0);
  EXPECT_EQ(sliderFraction(range, -1.0), 0.0);
}

}  // namespace
}  // namespace drape::ui
