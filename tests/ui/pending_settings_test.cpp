#include "ui/pending_settings.hpp"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(PendingSettings, LieOverTheSettingsInForce) {
  PendingSettings pending;
  pending.add(requireSetting("drag"), 2.0, 0.0);
  EXPECT_EQ(pending.overlay(Settings()).step.air.drag, 2.0);
}

TEST(PendingSettings, AreForgottenOnceTheyArrived) {
  PendingSettings pending;
  pending.add(requireSetting("drag"), 2.0, 0.0);
  Settings arrived;
  arrived.step.air.drag = 2.0;
  pending.update(arrived, 0.1, false);
  EXPECT_TRUE(pending.empty());
}

TEST(PendingSettings, AreForgottenWhenTheyWereRefused) {
  PendingSettings pending;
  pending.add(requireSetting("drag"), 2.0, 0.0);
  pending.update(Settings(), 0.5, false);
  EXPECT_FALSE(pending.empty());
  pending.update(Settings(), 2.0, false);
  EXPECT_TRUE(pending.empty());
}

TEST(PendingSettings, WaitForTheSceneAsLongAsItIsBeingBuilt) {
  PendingSettings pending;
  pending.add(requireSetting("grid.width"), 3.0, 0.0);
  pending.update(Settings(), 30.0, true);
  EXPECT_EQ(pending.overlay(Settings()).grid.width, 3.0);
  pending.update(Settings(), 32.0, false);
  EXPECT_TRUE(pending.empty());
}

}  // namespace
}  // namespace drape
