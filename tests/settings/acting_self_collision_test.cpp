#include "settings/acting_self_collision.hpp"

#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <string>

namespace drape::settings {
namespace {

TEST(ActingSelfCollision, dependsOnTheSolverOnlyWhenItIsAutomatic) {
  const auto acting = [](const char* solver, const char* method) {
    Settings settings;
    assignSettingExpression(settings, std::string("solver=") + solver);
    assignSettingExpression(settings, std::string("self_collision=") + method);
    return actingSelfCollision(settings);
  };
  EXPECT_EQ(acting("auto", "auto"), "exact");
  EXPECT_EQ(acting("one_iteration", "auto"), "hash");
  EXPECT_EQ(acting("one_iteration", "exact"), "exact");
  EXPECT_EQ(acting("auto", "hash"), "hash");
  EXPECT_EQ(acting("auto", "off"), "off");
}

TEST(ActingSelfCollision, makesTheThicknessOfTheHashRelevantOnlyWhereTheHashActs) {
  const SettingInfo& thickness = requireSetting("self_thickness");
  for (const char* solver : {"auto", "one_iteration"}) {
    for (const char* method : {"auto", "off", "hash", "exact"}) {
      Settings settings;
      assignSettingExpression(settings, std::string("solver=") + solver);
      assignSettingExpression(settings, std::string("self_collision=") + method);
      EXPECT_EQ(thickness.relevant(settings), actingSelfCollision(settings) == "hash") << solver << " " << method;
    }
  }
}

}  // namespace
}  // namespace drape::settings
