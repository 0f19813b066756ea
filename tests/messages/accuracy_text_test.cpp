#include "messages/accuracy_text.hpp"

#include <gtest/gtest.h>

namespace drape::messages {
namespace {

TEST(AccuracyText, tellsAKnownErrorWithTheTimeAfterWhichItIsReached) {
  EXPECT_EQ(inWords({.seconds = 0.2, .error = 2.04e-4, .spread = 2e-6}), "about 0.2 mm after 0.2 s");
}

TEST(AccuracyText, saysThatTheErrorCannotBeKnownWhereTinyDifferencesGrow) {
  EXPECT_EQ(inWords({.seconds = 0.2, .error = 2e-2, .spread = 1.5e-2}),
            "cannot be known: motions that start 1 \u00B5m apart are about 15 mm apart after 0.2 s");
}

}  // namespace
}  // namespace drape::messages
