#include "session/user_state.hpp"

#include <gtest/gtest.h>

namespace drape::session {
namespace {

TEST(RunningChanges, LeaveOutSettingsOfTheMesh) {
  settings::Settings to;
  to.step.air.drag = 3.0;
  to.grid.width = 4.0;
  const auto changes = runningChanges(settings::Settings(), to);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(std::get<SetSettingCommand>(changes.front()).key, "drag");
}

}  // namespace
}  // namespace drape::session
