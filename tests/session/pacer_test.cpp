#include "session/pacer.hpp"

#include <gtest/gtest.h>

namespace drape::session {
namespace {

int stepsTaken(Pacer& pacer, double timeStep) {
  int steps = 0;
  while (pacer.takeStep(timeStep)) {
    ++steps;
  }
  return steps;
}

TEST(Pacer, spendsTimeInWholeStepsAndKeepsTheRest) {
  Pacer pacer;
  int steps = 0;
  for (int frame = 0; frame < 60; ++frame) {
    pacer.collect(1.0 / 60.0, 1.0);
    steps += stepsTaken(pacer, 1.0 / 150.0);
  }
  EXPECT_NEAR(steps, 150, 1);
}

TEST(Pacer, dropsTheBacklogOfASlowMachine) {
  Pacer pacer;
  pacer.collect(10.0, 1.0);
  EXPECT_NEAR(stepsTaken(pacer, 0.01), Pacer::longestDebt / 0.01, 1);
}

TEST(Pacer, slowsDownAndSpeedsUp) {
  Pacer slow;
  slow.collect(0.1, 0.1);
  EXPECT_EQ(stepsTaken(slow, 0.0099), 1);
  Pacer fast;
  fast.collect(0.02, 4.0);
  EXPECT_EQ(stepsTaken(fast, 0.0099), 8);
}

TEST(Pacer, takesAStepAsLongAsItsLimitAtTheClocksPace) {
  Pacer pacer;
  int steps = 0;
  for (int frame = 0; frame < 600; ++frame) {
    pacer.collect(1.0 / 60.0, 1.0);
    steps += stepsTaken(pacer, 0.1);
  }
  EXPECT_NEAR(steps, 100, 1);
}

TEST(RealTimeFactor, isTheShareOfTheClockThatWasSimulated) {
  RealTimeFactor factor;
  for (int i = 0; i < 100; ++i) {
    factor.add(0.02, 0.005);
  }
  EXPECT_NEAR(factor.value(), 0.25, 1e-12);
  factor.reset();
  EXPECT_EQ(factor.value(), 0.0);
}

}  // namespace
}  // namespace drape::session
