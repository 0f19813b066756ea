#include "app/export/frame_name.hpp"

#include "messages/error.hpp"

#include <gtest/gtest.h>

namespace drape::app {
namespace {

TEST(FramePattern, putsTheNumberInPlaceOfThePlaceholder) {
  EXPECT_EQ(FramePattern("out/f_{frame:4}.png", 100).name(7), "out/f_0007.png");
  EXPECT_EQ(FramePattern("f{frame}.png", 100).name(12), "f12.png");
  EXPECT_EQ(FramePattern("f{frame:2}.png", 1000).name(123), "f123.png");
  EXPECT_EQ(FramePattern("one.png", 1).name(0), "one.png");
}

TEST(FramePattern, refusesNamesWithoutOrWithWrongPlaceholders) {
  for (const char* pattern :
       {"f.png", "f{frame.png", "f{fram}.png", "f{frame:0}.png", "f{frame:x}.png", "f{frame:10}.png", "f{}.png"}) {
    EXPECT_THROW(FramePattern(pattern, 2), messages::UsageError) << pattern;
  }
}

}  // namespace
}  // namespace drape::app
