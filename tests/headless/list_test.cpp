#include "program.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

nlohmann::json listOf(const std::string& what) {
  const Outcome outcome = headless("list " + what + " --json");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  return nlohmann::json::parse(outcome.output);
}

TEST(List, givesEverySettingWithKeyUnitRangeDefaultAndHelp) {
  const auto settings = listOf("settings");
  ASSERT_EQ(settings.size(), settings::settingsTable().size());
  for (const auto& setting : settings) {
    for (const char* part : {"key", "unit", "type", "range", "default", "help"}) {
      EXPECT_TRUE(setting.contains(part)) << setting;
    }
    EXPECT_EQ(setting["type"] == "number" || setting["type"] == "integer", setting.contains("min"));
  }
}

TEST(List, givesScenesAndSolvers) {
  EXPECT_GE(listOf("scenes").size(), 4U);
  EXPECT_EQ(listOf("solvers")[0]["name"], "one_iteration");
  EXPECT_EQ(listOf("hardcases").size(), 43U);
  EXPECT_EQ(listOf("validation")[0]["name"], "end_load_modulus");
}

TEST(List, isReadableWithoutJson) {
  EXPECT_NE(headless("list settings").output.find("stiffness = 100 N/m"), std::string::npos);
  EXPECT_NE(headless("list scenes").output.find("flag"), std::string::npos);
}

TEST(List, refusesUnknownLists) {
  EXPECT_EQ(headless("list colours").status, 2);
  EXPECT_EQ(headless("list").status, 2);
  EXPECT_EQ(headless("list scenes --markdown").status, 2);
}

}  // namespace
}  // namespace drape::app::testing
