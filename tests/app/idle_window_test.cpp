// Tests that a window in which nothing moves draws nothing.

#include "viewer_driver.hpp"

#include <gtest/gtest.h>

namespace drape::app {
namespace {

int pictures(const Json& state) {
  return state["picture"].get<int>();
}

/// The state after the time in which the window still draws after an event.
Json calm(ViewerDriver& viewer) {
  Json last = viewer.frames(8);
  for (int i = 0; i < 20; ++i) {
    Json next = viewer.frames(8);
    if (pictures(next) == pictures(last)) {
      return next;
    }
    last = std::move(next);
  }
  ADD_FAILURE() << "the window goes on drawing";
  return last;
}

TEST(IdleWindow, DrawsNoPictureWhilePausedUntilTheMouseMovesOverAButton) {
  ViewerDriver viewer({"curtain", "--paused"});
  const Json rest = calm(viewer);
  EXPECT_EQ(pictures(viewer.frames(4)), pictures(rest));
  viewer.move(viewer.find("button.play"));
  EXPECT_GT(pictures(viewer.frames(4)), pictures(rest)) << "the button lights up";
  const Json again = calm(viewer);
  viewer.key("space");
  EXPECT_GT(pictures(viewer.frames(10)), pictures(again) + 5) << "the cloth moves";
}

TEST(IdleWindow, DrawsTheWindowAgainAfterItWasCovered) {
  ViewerDriver viewer({"curtain", "--paused"});
  const Json rest = calm(viewer);
  viewer.send({"search", "--onlyvisible", "--name", "Drape", "windowunmap"});
  viewer.send({"search", "--name", "Drape", "windowmap"});
  viewer.waitUntil("a new picture", [&](const Json& state) { return pictures(state) > pictures(rest); });
}

}  // namespace
}  // namespace drape::app
