#include "fields/colour_map.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::fields {
namespace {

/// CIE lightness of a screen colour, 0 to 100.
double lightness(const ScreenColour& colour) {
  const auto linear = [](float c) { return c <= 0.04045F ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(ColourMap, OfMagnitudesBecomesBrighterByEqualSteps) {
  const double whole = lightness(colourAt(magnitudeColours(), 1.0)) - lightness(colourAt(magnitudeColours(), 0.0));
  for (int i = 0; i < 20; ++i) {
    const double step =
        lightness(colourAt(magnitudeColours(), (i + 1) / 20.0)) - lightness(colourAt(magnitudeColours(), i / 20.0));
    EXPECT_NEAR(step, whole / 20.0, 0.3 * whole / 20.0) << i;
  }
}

TEST(ColourMap, OfASignIsBrightestInTheMiddleAndEvenlyDarkAtTheEnds) {
  const double middle = lightness(colourAt(signedColours(), 0.5));
  EXPECT_GT(middle, 95.0);
  for (const double place : {0.05, 0.15, 0.25, 0.35, 0.45}) {
    const double low = lightness(colourAt(signedColours(), place));
    EXPECT_LT(low, middle);
    EXPECT_NEAR(low, lightness(colourAt(signedColours(), 1.0 - place)), 12.0) << place;
  }
  EXPECT_GT(colourAt(signedColours(), 0.2)[2], colourAt(signedColours(), 0.2)[0]) << "blue below";
  EXPECT_GT(colourAt(signedColours(), 0.8)[0], colourAt(signedColours(), 0.8)[2]) << "red above";
}

TEST(ColourMap, GivesValuesOutsideTheRangeTheColoursOfItsEnds) {
  EXPECT_EQ(colourAt(magnitudeColours(), -3.0), magnitudeColours().front());
  EXPECT_EQ(colourAt(magnitudeColours(), 7.0), magnitudeColours().back());
}

TEST(ColourMap, IsThatOfASignForFieldsWithASign) {
  for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
    EXPECT_EQ(&coloursOf(field), field.hasSign ? &signedColours() : &magnitudeColours()) << field.name;
  }
}

}  // namespace
}  // namespace drape::fields
