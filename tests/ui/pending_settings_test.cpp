#include "ui/pending_settings.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

TEST(PendingSettings, LieOverTheSettingsInForce) {
  PendingSettings pending;
  pending.add(settings::requireSetting("drag"), 2.0, 0.0);
  EXPECT_EQ(pending.overlay(settings::Settings()).step.air.drag, 2.0);
}

TEST(PendingSettings, AreForgottenOnceTheyArrived) {
  PendingSettings pending;
  pending.add(settings::requireSetting("drag"), 2.0, 0.0);
  settings::Settings arrived;
  arrived.step.air.drag = 2.0;
  pending.update(arrived, 0.1, false);
  EXPECT_TRUE(pending.empty());
}

TEST(PendingSettings, AreForgottenWhenTheyWereRefused) {
  PendingSettings pending;
  pending.add(settings::requireSetting("drag"), 2.0, 0.0);
  pending.update(settings::Settings(), 0.5, false);
  EXPECT_FALSE(pending.empty());
  pending.update(settings::Settings(), 2.0, false);
  EXPECT_TRUE(pending.empty());
}

TEST(PendingSettings, WaitForTheSceneAsLongAsItIsBeingBuilt) {
  PendingSettings pending;
  pending.add(settings::requireSetting("grid.width"), 3.0, 0.0);
  pending.update(settings::Settings(), 30.0, true);
  EXPECT_EQ(pending.overlay(settings::Settings()).grid.width, 3.0);
  pending.update(settings::Settings(), 32.0, false);
  EXPECT_TRUE(pending.empty());
}

}  // namespace
}  // namespace drape::ui
