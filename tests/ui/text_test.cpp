#include "ui/text.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

TEST(Text, PaceIsInWords) {
  session::Snapshot snapshot;
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

TEST(Slowness, NamesContactIfItTakesMoreThanHalfOfAStep) {
  session::Snapshot snapshot;
  snapshot.stepSeconds = 0.010;
  snapshot.stepReport.contact.bodySeconds = 0.002;
  snapshot.stepReport.contact.selfSeconds = 0.002;
  EXPECT_EQ(slownessInWords(snapshot).english().find("contact"), std::string::npos);
  snapshot.stepReport.substepContactSeconds = 0.0005;
  EXPECT_EQ(slownessInWords(snapshot).english().find("contact"), std::string::npos);
  snapshot.stepReport.substepContactSeconds = 0.0015;  // in the substeps of the solver
  EXPECT_NE(slownessInWords(snapshot).english().find("contact"), std::string::npos);
  snapshot.stepReport.contact.bodySeconds = 0.004;
  EXPECT_NE(slownessInWords(snapshot).english().find("mostly because of contact with bodies"), std::string::npos);
  snapshot.stepReport.contact.selfSeconds = 0.005;
  EXPECT_NE(slownessInWords(snapshot).english().find("mostly because of contact of the cloth with itself"),
            std::string::npos);
}

TEST(Text, ShorteningNeverSplitsALetter) {
  EXPECT_EQ(shortened("short", 10), "short");
  EXPECT_EQ(shortened("\u00E4\u00F6\u00FC\u00DF", 2), "\u00E4\u00F6\u2026");
}

}  // namespace
}  // namespace drape::ui
