#include "text/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace drape::text {
namespace {

TEST(NumberText, NumbersKeepAboutThreeDigits) {
  EXPECT_EQ(formatNumber(0.0), "0");
  EXPECT_EQ(formatNumber(0.01234), "0.0123");
  EXPECT_EQ(formatNumber(1.2345), "1.23");
  EXPECT_EQ(formatNumber(-45.67), "-45.7");
  EXPECT_EQ(formatNumber(150.0), "150");
  EXPECT_EQ(formatNumber(1.23e-5), "1.23e-05");
  EXPECT_EQ(formatNumber(std::numeric_limits<double>::quiet_NaN()), "not finite");
}

TEST(NumberText, DurationsChooseTheirUnit) {
  EXPECT_EQ(formatDuration(9.4e-6), "9.4 \u00B5s");
  EXPECT_EQ(formatDuration(228e-6), "228 \u00B5s");
  EXPECT_EQ(formatDuration(0.0167), "16.70 ms");
  EXPECT_EQ(formatDuration(0.25), "250 ms");
}

TEST(NumberText, CountsAreGrouped) {
  EXPECT_EQ(formatCount(0), "0");
  EXPECT_EQ(formatCount(289), "289");
  EXPECT_EQ(formatCount(1050625), "1\u00A0050\u00A0625");
}

TEST(NumberText, FiguresHaveSignificantDigitsAndNoExponentBelowAMillion) {
  EXPECT_EQ(figure(0.012345), "0.0123");
  EXPECT_EQ(figure(2.0), "2");
  EXPECT_EQ(figure(1.2e-5), "1.2e-05");
  EXPECT_EQ(figure(12345.6), "12346");
  EXPECT_EQ(figure(1.0e6), "1e+06");
  EXPECT_EQ(figure(0.123456, 5), "0.12346");
  EXPECT_EQ(figure(std::numeric_limits<double>::infinity()), "-");
}

TEST(NumberText, RoundedFiguresEndInZeros) {
  EXPECT_EQ(roundedFigure(123456.0), "120000");
  EXPECT_EQ(roundedFigure(1250.0, 1), "1000");
  EXPECT_EQ(roundedFigure(12.34), "12");
  EXPECT_EQ(roundedFigure(0.0123), "0.012");
}

TEST(NumberText, ExactNumbersReadBackAsTheSameNumber) {
  EXPECT_EQ(exactNumber(0.1), "0.1");
  EXPECT_EQ(exactNumber(1e5), "1e+05");
  for (const double value : {1.0 / 3.0, 1.0 / 150.0, 6.02214076e23, -0.0}) {
    EXPECT_EQ(parseNumber(exactNumber(value)), value);
  }
}

TEST(NumberText, LongTimesHaveMinutes) {
  EXPECT_EQ(formatMinutes(59.4), "59 s");
  EXPECT_EQ(formatMinutes(59.6), "1 min 0 s");
  EXPECT_EQ(formatMinutes(125.0), "2 min 5 s");
}

TEST(NumberText, LengthsChooseTheirUnit) {
  EXPECT_EQ(formatLength(2500.0), "2.5 km");
  EXPECT_EQ(formatLength(1.5), "1.5 m");
  EXPECT_EQ(formatLength(0.0123), "12.3 mm");
  EXPECT_EQ(formatLength(2e-6), "2 um");
  EXPECT_EQ(formatLength(0.0), "0 m");
}

TEST(NumberText, RoundNumbersAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(nextRoundNumber(0.03), 0.05);
  EXPECT_DOUBLE_EQ(nextRoundNumber(2.0), 2.0);
  EXPECT_DOUBLE_EQ(nextRoundNumber(2.0 * (1.0 + 1e-12)), 2.0);
  EXPECT_DOUBLE_EQ(nextRoundNumber(501.0), 1000.0);
}

TEST(NumberText, FractionsAreNumbers) {
  EXPECT_EQ(parseNumber("1/150"), 1.0 / 150.0);
  EXPECT_EQ(parseNumber("+2.5"), 2.5);
  EXPECT_EQ(parseNumber("1/"), std::nullopt);
  EXPECT_EQ(parseNumber("1 m"), std::nullopt);
  EXPECT_EQ(parseNumber(""), std::nullopt);
}

}  // namespace
}  // namespace drape::text
