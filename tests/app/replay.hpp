#pragma once

#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace drape::app {

/// Replays a recorded session without a window. Fails the test unless the replay succeeds.
inline void expectReplay(const std::filesystem::path& log) {
  const auto output = log.parent_path() / "output.txt";
  const int status = runToEnd({.command = {DRAPE_HEADLESS, "run", "--replay", log.string()}, .output = output});
  EXPECT_EQ(status, 0) << contentOf(output);
}

}  // namespace drape::app
