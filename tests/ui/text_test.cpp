#include "ui/text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace drape {
namespace {

TEST(Text, NumbersKeepAboutThreeDigits) {
  EXPECT_EQ(formatNumber(0.0), "0");
  EXPECT_EQ(formatNumber(0.01234), "0.0123");
  EXPECT_EQ(formatNumber(1.2345), "1.23");
  EXPECT_EQ(formatNumber(-45.67), "-45.7");
  EXPECT_EQ(formatNumber(150.0), "150");
  EXPECT_EQ(formatNumber(1.23e-5), "1.23e-05");
  EXPECT_EQ(formatNumber(std::numeric_limits<double>::quiet_NaN()), "not finite");
}

TEST(Text, DurationsChooseTheirUnit) {
  EXPECT_EQ(formatDuration(9.4e-6), "9.4 \u00B5s");
  EXPECT_EQ(formatDuration(228e-6), "228 \u00B5s");
  EXPECT_EQ(formatDuration(0.0167), "16.70 ms");
  EXPECT_EQ(formatDuration(0.25), "250 ms");
}

TEST(Text, CountsAreGrouped) {
  EXPECT_EQ(formatCount(0), "0");
  EXPECT_EQ(formatCount(289), "289");
  EXPECT_EQ(formatCount(1050625), "1\u00A0050\u00A0625");
}

TEST(Text, PaceIsInWords) {
  Snapshot snapshot;
  snapshot.realTimeFactor = 0.414;
  EXPECT_EQ(describePace(snapshot), "0.4 \u00D7 real time: too slow");
  snapshot.realTimeFactor = 0.0123;
  EXPECT_EQ(describePace(snapshot), "0.012 \u00D7 real time: too slow");
  snapshot.realTimeFactor = 0.98;
  EXPECT_EQ(describePace(snapshot), "real time");
  snapshot.settings.playback.speed = 0.5;
  snapshot.realTimeFactor = 0.5;
  EXPECT_EQ(describePace(snapshot), "0.5 \u00D7 real time") << "as slow as it was asked to be";
  snapshot.realTimeFactor = 0.0;
  EXPECT_EQ(describePace(snapshot), "not timed");
  snapshot.paused = true;
  EXPECT_EQ(describePace(snapshot), "paused");
}

TEST(Text, ShorteningNeverSplitsALetter) {
  EXPECT_EQ(shortened("short", 10), "short");
  EXPECT_EQ(shortened("\u00E4\u00F6\u00FC\u00DF", 2), "\u00E4\u00F6\u2026");
}

}  // namespace
}  // namespace drape
