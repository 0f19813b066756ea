#include "settings/own_fabrics.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>

namespace drape::settings {
namespace {

Settings withFabric(std::string_view preset) {
  Settings settings;
  assignSetting(settings, requireSetting("material.preset"), std::string(preset));
  return settings;
}

std::string presetIn(const Settings& settings) {
  return formatValue(settingValue(settings, requireSetting("material.preset")));
}

OwnFabric softDenim() {
  OwnFabric fabric = fabricOf(withFabric("denim"), "Soft denim");
  fabric.material.bendWarp = 1e-5;
  fabric.material.bendWeft = 1e-5;
  fabric.material.bendBias = 1e-5;
  return fabric;
}

std::string refusalOf(const OwnFabric& fabric) {
  try {
    requireAllowed(fabric);
    return "";
  } catch (const messages::UsageError& error) {
    return error.what();
  }
}

TEST(OwnFabrics, consistOfExactlyTheValuesThatAPresetSets) {
  std::set<std::string_view> set;
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    for (const SettingInfo* info : differingSettings(Settings{}, withFabric(preset.name))) {
      set.insert(info->key);
    }
  }
  for (const char* other : {"material.preset", "self_friction", "self_static_friction", "body_friction"}) {
    EXPECT_EQ(set.erase(other), 1U) << other;
  }
  const auto keys = fabricValueKeys();
  EXPECT_EQ(set, std::set<std::string_view>(keys.begin(), keys.end()));
}

TEST(OwnFabrics, refuseBadNamesWithARemedy) {
  for (const auto& [name, expected] : {std::pair<std::string, const char*>("", "needs a name"),
                                       {"   ", "needs a name"},
                                       {"denim", "belongs to the built-in fabric Denim"},
                                       {"DENIM", "belongs to the built-in fabric Denim"},
                                       {"Jersey (knit)", "belongs to the built-in fabric"},
                                       {"Custom", "choose another name"},
                                       {"mine, changed", "choose another name"},
                                       {" mine", "blank"},
                                       {"mine\n", "control characters"},
                                       {std::string(41, 'x'), "at most 40 bytes"}}) {
    EXPECT_NE(problemWithFabricName(name).find(expected), std::string::npos) << problemWithFabricName(name);
  }
  for (const char* name : {"mine", "Soft denim", "denim 2", "a=b", "\u00C9t\u00E9", "my_silk"}) {
    EXPECT_EQ(problemWithFabricName(name), "") << name;
  }
}

TEST(OwnFabrics, refuseValuesOutOfRangeAndUnstableOnesWithTheirName) {
  EXPECT_EQ(refusalOf(softDenim()), "");
  OwnFabric negative = softDenim();
  negative.material.shear = -1.0;
  EXPECT_NE(refusalOf(negative).find("the fabric 'Soft denim': fabric.shear must be 0.1"), std::string::npos)
      << refusalOf(negative);
  OwnFabric twisting = softDenim();
  twisting.material.bendBias = 1e-6;
  EXPECT_NE(refusalOf(twisting).find("'Soft denim': fabric.bend_bias must be at least"), std::string::npos);
  OwnFabric light = softDenim();
  light.density = 0.0;
  EXPECT_NE(refusalOf(light).find("fabric.density must be"), std::string::npos);
  OwnFabric based = softDenim();
  based.basedOn = "cardboard";
  EXPECT_NE(refusalOf(based).find("'cardboard' is not"), std::string::npos);
}

TEST(OwnFabrics, areChosenByNameAndNamedOnceTheyChange) {
  Settings settings;
  settings.fabric.own = withOwnFabric({}, softDenim());
  assignSettingExpression(settings, "material.preset=Soft denim");
  EXPECT_EQ(settings.fabric.moduli, softDenim().material);
  EXPECT_EQ(settings.fabric.density, softDenim().density);
  EXPECT_EQ(presetIn(settings), "Soft denim");
  EXPECT_EQ(fabricTitle(settings), "Soft denim");
  assignSettingExpression(settings, "fabric.shear=60");
  EXPECT_EQ(presetIn(settings), "Soft denim, changed");
  EXPECT_EQ(fabricOf(settings, "softer").basedOn, "denim") << "the look is that of the built-in fabric";
  EXPECT_THROW(assignSettingExpression(settings, "material.preset=Hard denim"), messages::UsageError);
  EXPECT_THROW(assignSettingExpression(settings, "material.preset=Hard denim, changed"), messages::UsageError);
}

TEST(OwnFabrics, areNamedInTheRangeOfThePreset) {
  Settings settings;
  settings.fabric.own = withOwnFabric({}, softDenim());
  try {
    assignSettingExpression(settings, "material.preset=cardboard");
    FAIL();
  } catch (const messages::UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("rubber or Soft denim, or custom; 'cardboard' is not"), std::string::npos)
        << error.what();
  }
}

TEST(OwnFabrics, replaceOneOfTheSameName) {
  OwnFabric heavy = softDenim();
  heavy.density = 1.0;
  const OwnFabrics two = withOwnFabric(withOwnFabric({}, softDenim()), fabricOf(withFabric("silk"), "Mine"));
  const OwnFabrics changed = joined(two, withOwnFabric({}, heavy));
  ASSERT_EQ(changed->size(), 2U);
  EXPECT_EQ(findOwnFabric(changed, "Soft denim")->density, 1.0);
  EXPECT_EQ(findOwnFabric(two, "Soft denim")->density, softDenim().density) << "the old list does not change";
  EXPECT_EQ(findOwnFabric(changed, "Yours"), nullptr);
}

TEST(ChangedFabric, keepsItsNameThroughALogAndSetsNoValue) {
  Settings settings = withFabric("denim");
  assignSettingExpression(settings, "fabric.shear=60");
  EXPECT_EQ(fabricTitle(settings), "Denim, changed");
  Settings again;
  assignSettingExpression(again, "material.preset=" + presetIn(settings));
  EXPECT_EQ(again.fabric.moduli, Settings{}.fabric.moduli) << "the values follow one by one";
  for (const std::string_view key : fabricValueKeys()) {
    const SettingInfo& info = requireSetting(key);
    assignSettingText(again, info, formatValue(settingValue(settings, info)));
  }
  EXPECT_EQ(presetIn(again), "denim, changed");
  EXPECT_EQ(again.fabric.moduli, settings.fabric.moduli);
}

}  // namespace
}  // namespace drape::settings
