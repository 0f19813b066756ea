#include "settings/settings_table.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "sim/solvers/solver.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace drape::settings {
namespace {

/// The message with which a value is refused, or "" when it is accepted.
std::string refusal(const std::string& expression) {
  Settings settings;
  try {
    assignSettingExpression(settings, expression);
    requireConsistent(settings);
    return "";
  } catch (const messages::UsageError& error) {
    return error.what();
  }
}

TEST(SettingsTable, hasEveryKeyOnceWithTitleUnitAndHelp) {
  std::set<std::string_view> keys;
  for (const SettingInfo& info : settingsTable()) {
    EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    EXPECT_FALSE(info.title.empty()) << info.key;
    EXPECT_FALSE(info.unit.empty()) << info.key;
    EXPECT_GT(info.help.size(), 10U) << info.key;
    EXPECT_EQ(info.alsoKey.empty(), info.alsoValue.empty()) << info.key;
    EXPECT_TRUE(info.alsoKey.empty() || findSetting(info.alsoKey) != nullptr) << info.key;
    EXPECT_LE(depthOf(info), maxDepth) << info.key;
  }
  for (const char* key : {"time_step", "stiffness", "damping", "mass", "density", "gravity", "drag", "lift", "wind.x",
                          "wind.y", "wind.z", "sweeps", "solver", "unit", "grid.resolution"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

TEST(SettingsTable, takesEveryDefaultAndEveryLimitAndReadsItBack) {
  for (const SettingInfo& info : settingsTable()) {
    Settings settings;
    EXPECT_NO_THROW(assignSetting(settings, info, defaultValue(info))) << info.key;
    std::vector<SettingValue> values{defaultValue(info)};
    if (const auto* number = std::get_if<NumberField>(&info.field)) {
      values = {number->min, number->max};
    } else if (const auto* integer = std::get_if<IntegerField>(&info.field)) {
      values = {integer->min, integer->max};
    }
    for (const SettingValue& value : values) {
      assignSettingText(settings, info, formatValue(value));
      EXPECT_EQ(settingValue(settings, info), value) << info.key;
    }
  }
}

TEST(SettingsTable, refusesNumbersOutOfRangeWithKeyRangeAndUnit) {
  for (const SettingInfo& info : settingsTable()) {
    if (const auto* number = std::get_if<NumberField>(&info.field)) {
      Settings settings;
      const SettingValue before = settingValue(settings, info);
      EXPECT_THROW(assignSetting(settings, info, number->max * 2.0 + 1.0), messages::UsageError) << info.key;
      EXPECT_THROW(assignSetting(settings, info, number->min - 1.0), messages::UsageError) << info.key;
      EXPECT_EQ(settingValue(settings, info), before) << info.key;
    }
  }
  const std::string message = refusal("stiffness=-3");
  EXPECT_NE(message.find("stiffness must be 0 to 1e+07 N/m"), std::string::npos) << message;
  EXPECT_NE(message.find("-3"), std::string::npos) << message;
}

TEST(SettingsTable, refusesTextThatIsNoNumber) {
  for (const char* text : {"nan", "inf", "-inf", "", "1e", "abc", "1.0x", "0x10", "1/0", "0/0", "1/", "/2", "1e999"}) {
    EXPECT_NE(refusal(std::string("time_step=") + text), "") << text;
  }
}

TEST(SettingsTable, readsFractions) {
  Settings settings;
  assignSettingExpression(settings, "time_step=1/240");
  EXPECT_DOUBLE_EQ(settings.step.timeStep, 1.0 / 240.0);
}

TEST(SettingsTable, refusesEvenSweepsWithTheReason) {
  EXPECT_NE(refusal("sweeps=2").find("even number"), std::string::npos);
  EXPECT_NE(refusal("sweeps=0"), "");
  EXPECT_NE(refusal("sweeps=1.5"), "");
  EXPECT_EQ(refusal("sweeps=5"), "");
}

TEST(SettingsTable, takesEvenSweepsOfDampedJacobi) {
  Settings settings;
  assignSettingExpression(settings, "sweeps=4");
  EXPECT_THROW(requireConsistent(settings), messages::UsageError);
  assignSettingExpression(settings, "relaxation=0.81");
  EXPECT_THROW(requireConsistent(settings), messages::UsageError);
  assignSettingExpression(settings, "relaxation=0.8");
  EXPECT_NO_THROW(requireConsistent(settings));
}

TEST(SettingsTable, tellsWhichSettingsHaveAnEffect) {
  Settings settings;
  EXPECT_TRUE(isRelevant(requireSetting("auto.cost"), settings));
  EXPECT_FALSE(isRelevant(requireSetting("substeps"), settings)) << "auto chooses its own";
  assignSettingExpression(settings, "auto.budget=5");
  EXPECT_FALSE(isRelevant(requireSetting("auto.cost"), settings)) << "auto.budget sets it";
  settings.solver.name = "one_iteration";
  EXPECT_TRUE(isRelevant(requireSetting("substeps"), settings));
  EXPECT_TRUE(isRelevant(requireSetting("stiffness"), settings));
  EXPECT_TRUE(isRelevant(requireSetting("sweeps"), settings));
  EXPECT_FALSE(isRelevant(requireSetting("theta"), settings));
  assignSettingExpression(settings, "integration=theta");
  EXPECT_TRUE(isRelevant(requireSetting("theta"), settings));
}

TEST(SettingsTable, showsTheSettingsOfTheGhostsSolver) {
  Settings settings;
  EXPECT_FALSE(isRelevant(requireSetting("ghost.substeps"), settings));
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    settings.ghost.solver = solver.name;
    EXPECT_TRUE(isRelevant(requireSetting("ghost.substeps"), settings));
    for (const std::string_view key : solver.settings) {
      EXPECT_TRUE(isRelevant(requireSetting(key), settings)) << solver.name << ": " << key;
    }
  }
}

TEST(ChoiceTitle, isTheTitleOrTheWordWithGaps) {
  const auto& solvers = std::get<ChoiceField>(requireSetting("solver").field);
  EXPECT_EQ(choiceTitle(solvers, "one_iteration"), sim::findSolver("one_iteration")->title);
  EXPECT_EQ(choiceTitle(std::get<ChoiceField>(requireSetting("ghost.solver").field), "off"), "Off");
  EXPECT_EQ(choiceTitle(std::get<ChoiceField>(requireSetting("integration").field), "bdf2"), "BDF2");
  EXPECT_EQ(choiceTitle(ChoiceField{nullptr, nullptr, nullptr}, "two_words"), "two words");
}

TEST(ChoiceTitle, existsForEveryWordWithALabel) {
  for (const SettingInfo& info : settingsTable()) {
    const auto* choice = std::get_if<ChoiceField>(&info.field);
    if (choice == nullptr || choice->label == nullptr) {
      continue;
    }
    std::set<std::string> titles;
    for (const std::string& word : choice->choices()) {
      EXPECT_TRUE(titles.insert(choiceTitle(*choice, word)).second) << info.key << ": " << word;
      EXPECT_GT(choice->label(word).help.size(), 10U) << info.key << ": " << word;
    }
  }
}

TEST(SettingsTable, readsAndWritesEveryWordOfEveryChoice) {
  for (const SettingInfo& info : settingsTable()) {
    if (const auto* choice = std::get_if<ChoiceField>(&info.field)) {
      for (const std::string& word : choice->choices()) {
        Settings settings;
        assignSetting(settings, info, word);
        EXPECT_EQ(settingValue(settings, info), SettingValue(word)) << info.key;
      }
    }
  }
}

TEST(SolverTable, namesOnlySettingsThatExist) {
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    for (const std::string_view key : solver.settings) {
      EXPECT_NE(findSetting(key), nullptr) << solver.name << ": " << key;
    }
  }
}

TEST(SettingsTable, namesTheNearestKeyForAMistypedOne) {
  EXPECT_NE(refusal("stifness=10").find("did you mean 'stiffness'"), std::string::npos);
  EXPECT_NE(refusal("wind=3").find("wind.x"), std::string::npos);
  EXPECT_NE(refusal("stif=3").find("did you mean 'stiffness'"), std::string::npos);
}

TEST(SettingsTable, namesTheNearestWordForAMistypedChoice) {
  for (const char* mistyped : {"material.preset=Cotton", "material.preset=cottn", "material.preset=cott"}) {
    EXPECT_NE(refusal(mistyped).find("Did you mean 'cotton'?"), std::string::npos) << refusal(mistyped);
  }
  EXPECT_NE(refusal("solver=Auto").find("Did you mean 'auto'?"), std::string::npos) << refusal("solver=Auto");
  EXPECT_EQ(refusal("material.preset=cardboard").find("Did you mean"), std::string::npos);
  EXPECT_EQ(refusal("solver=").find("Did you mean"), std::string::npos);
}

TEST(SettingsTable, namesAnOwnFabricForAMistypedOne) {
  Settings settings;
  settings.fabric.own = withOwnFabric({}, fabricOf(settings, "Soft denim"));
  try {
    assignSettingExpression(settings, "material.preset=soft denim");
    FAIL();
  } catch (const messages::UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("Did you mean 'Soft denim'?"), std::string::npos) << error.what();
  }
}

TEST(SettingsTable, saysWhichSettingsConflict) {
  Settings settings;
  settings.fabric.moduli.bendBias = 0.0;
  try {
    requireConsistent(settings);
    FAIL();
  } catch (const ConflictError& error) {
    EXPECT_EQ(error.keys().front(), "fabric.bend_bias");
    EXPECT_EQ(error.keys().size(), 3U);
    for (const std::string_view key : error.keys()) {
      EXPECT_NE(findSetting(key), nullptr) << key;
    }
  }
}

TEST(SettingsTable, takesFormerKeysAndNamesThePresentOnes) {
  Settings settings;
  assignSettingExpression(settings, "hand.stiffness=100");
  assignSettingExpression(settings, "hand.max_force=2");
  assignSettingExpression(settings, "auto.work=7");
  EXPECT_EQ(settings.attachment.stiffness, 100.0);
  EXPECT_EQ(settings.attachment.maxForce, 2.0);
  EXPECT_EQ(settingValue(settings, requireSetting("auto.cost")), SettingValue(7.0));
  EXPECT_EQ(formerKeyNote("hand.stiffness"), "the setting 'hand.stiffness' is now called 'attachment.stiffness'");
  EXPECT_EQ(formerKeyNote("hand.max_force"), "the setting 'hand.max_force' is now called 'attachment.max_force'");
  EXPECT_EQ(formerKeyNote("auto.work"), "the setting 'auto.work' is now called 'auto.cost'");
  EXPECT_EQ(formerKeyNote("auto.cost"), "");
  EXPECT_EQ(formerKeyNote("no_setting"), "");
}

TEST(SettingsTable, hasNoFormerKeyThatIsAlsoAPresentOne) {
  std::set<std::string_view> keys;
  for (const SettingInfo& info : settingsTable()) {
    EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    EXPECT_TRUE(info.formerKey.empty() || keys.insert(info.formerKey).second) << info.formerKey;
  }
}

TEST(SettingsTable, suggestsNothingForAWordThatIsLikeNoKey) {
  for (const char* word : {"foo=1", "x=1", "qqqq=1", "colour_of_the_sky=1"}) {
    EXPECT_EQ(refusal(word).find("did you mean"), std::string::npos) << refusal(word);
    EXPECT_NE(refusal(word).find("list settings"), std::string::npos) << refusal(word);
  }
}

TEST(SettingsTable, takesAFactorAsTheUnitOfAMesh) {
  Settings settings;
  for (const auto& [text, value] : {std::pair("0.0254", "0.0254"), std::pair("1/3", "1/3"), std::pair("1e-6", "1e-6"),
                                    std::pair("1000", "1000"), std::pair("inch", "inch"), std::pair("auto", "auto")}) {
    assignSettingExpression(settings, std::string("unit=") + text);
    EXPECT_EQ(settings.mesh.unit, value);
  }
  assignSetting(settings, requireSetting("unit"), 0.3048);
  EXPECT_EQ(settings.mesh.unit, "0.3048") << "a number in a scene file";
  for (const char* wrong :
       {"unit=0", "unit=-1", "unit=1e-7", "unit=1001", "unit=nan", "unit=inf", "unit=", "unit=1 cm"}) {
    EXPECT_NE(refusal(wrong).find("metres per unit from 1e-06 to 1000"), std::string::npos) << wrong;
  }
}

TEST(SettingsTable, refusesAnExpressionWithoutKeyOrValue) {
  EXPECT_NE(refusal("stiffness").find("key=value"), std::string::npos);
  EXPECT_NE(refusal("=3").find("key=value"), std::string::npos);
}

TEST(SettingsTable, listsTheChoicesWhenAWordIsNone) {
  EXPECT_NE(refusal("unit=yard").find("mm, inch or foot, or metres per unit from 1e-06 to 1000; 'yard' is not"),
            std::string::npos)
      << refusal("unit=foot");
  EXPECT_NE(refusal("solver=magic").find("one_iteration"), std::string::npos);
}

TEST(SettingsTable, letsMassAndDensityDecideWhichOfThemCounts) {
  Settings settings;
  assignSettingExpression(settings, "mass=0.3");
  EXPECT_EQ(settings.material.massGivenAs, "mass");
  EXPECT_DOUBLE_EQ(settings.material.mass, 0.3);
  assignSettingExpression(settings, "density=0.2");
  EXPECT_EQ(settings.material.massGivenAs, "density");
}

TEST(FabricSettings, areSpringsUnlessAFabricIsChosen) {
  Settings settings;
  EXPECT_FALSE(usesFabric(settings));
  EXPECT_FALSE(weighsAsFabric(settings));
  EXPECT_EQ(settingValue(settings, requireSetting("mass_given_as")), SettingValue(std::string("density")));
  EXPECT_TRUE(isRelevant(requireSetting("stiffness"), settings));
  EXPECT_FALSE(isRelevant(requireSetting("fabric.shear"), settings));
  EXPECT_FALSE(isRelevant(requireSetting("material.preset"), settings));
  assignSettingExpression(settings, "material.model=fabric");
  EXPECT_TRUE(usesFabric(settings));
  EXPECT_FALSE(isRelevant(requireSetting("stiffness"), settings));
  EXPECT_FALSE(isRelevant(requireSetting("damping"), settings));
  EXPECT_TRUE(isRelevant(requireSetting("fabric.shear"), settings));
  EXPECT_TRUE(isRelevant(requireSetting("material.preset"), settings));
  EXPECT_NE(refusal("material.model=jelly").find("material.model must be springs or fabric"), std::string::npos);
}

TEST(FabricSettings, givenToSpringsForTheirLookHaveAnEffect) {
  Settings settings;
  assignSettingExpression(settings, "view.surface=fabric");
  for (const char* key : {"material.preset", "fabric.warp_angle"}) {
    EXPECT_TRUE(isRelevant(requireSetting(key), settings)) << key;
    EXPECT_EQ(noEffectNote(settings, key), "") << key;
  }
  EXPECT_FALSE(isRelevant(requireSetting("fabric.shear"), settings));
}

TEST(FabricSettings, takeTheValuesOfEveryPreset) {
  const SettingInfo& info = requireSetting("material.preset");
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    Settings settings;
    assignSetting(settings, info, std::string(preset.name));
    EXPECT_EQ(settings.fabric.moduli, preset.material) << preset.name;
    EXPECT_EQ(settings.fabric.density, preset.density) << preset.name;
    EXPECT_NO_THROW(requireConsistent(settings)) << preset.name;
    // A session log assigns each value again, within its range.
    for (const SettingInfo& each : settingsTable()) {
      assignSettingText(settings, each, formatValue(settingValue(settings, each)));
    }
    EXPECT_EQ(settingValue(settings, info), SettingValue(std::string(preset.name)));
  }
  EXPECT_NE(refusal("material.preset=cardboard").find("leather or rubber, or custom; 'cardboard' is not"),
            std::string::npos);
}

TEST(FabricSettings, nameThePresetAsChangedOnceAValueDiffers) {
  Settings settings;
  const SettingInfo& info = requireSetting("material.preset");
  assignSettingExpression(settings, "material.preset=denim");
  assignSettingExpression(settings, "fabric.warp_angle=45");
  EXPECT_EQ(settingValue(settings, info), SettingValue(std::string("denim"))) << "the cut is not the fabric";
  assignSettingExpression(settings, "fabric.shear=54");
  EXPECT_EQ(settingValue(settings, info), SettingValue(std::string("denim, changed")));
  assignSettingExpression(settings, "material.preset=custom");
  EXPECT_EQ(settings.fabric.moduli.shear, 54.0) << "custom changes nothing";
  assignSettingExpression(settings, "fabric.shear=53");
  EXPECT_EQ(settingValue(settings, info), SettingValue(std::string("denim")));
  assignSettingExpression(settings, "fabric.density=0.4");
  EXPECT_EQ(settingValue(settings, info), SettingValue(std::string("custom")));
}

TEST(FabricSettings, letTheFabricWeighUnlessDensityOrMassIsGiven) {
  for (const char* given : {"density=0.5", "mass=0.5", "mass_given_as=density"}) {
    Settings settings;
    assignSettingExpression(settings, "material.model=fabric");
    EXPECT_TRUE(weighsAsFabric(settings));
    EXPECT_FALSE(isRelevant(requireSetting("density"), settings));
    assignSettingExpression(settings, given);
    EXPECT_FALSE(weighsAsFabric(settings)) << given;
    EXPECT_TRUE(isRelevant(requireSetting("density"), settings)) << given;
    assignSettingExpression(settings, "material.preset=denim");
    EXPECT_FALSE(weighsAsFabric(settings)) << given;
    assignSettingExpression(settings, "fabric.own_density=on");
    EXPECT_TRUE(weighsAsFabric(settings)) << given;
  }
}

TEST(FabricSettings, areNotedWhereTheClothConsistsOfSprings) {
  Settings settings;
  EXPECT_EQ(noEffectNote(settings, "material.preset"),
            "the setting 'material.preset' has no effect while material.model is springs");
  for (const char* key : {"fabric.shear", "fabric.density", "fabric.warp_angle"}) {
    EXPECT_NE(noEffectNote(settings, key), "") << key;
  }
  for (const char* key : {"stiffness", "damping", "density", "material.model", "sweeps", "wind.x", "no_setting"}) {
    EXPECT_EQ(noEffectNote(settings, key), "") << key;
  }
  assignSettingExpression(settings, "material.model=fabric");
  EXPECT_EQ(noEffectNote(settings, "material.preset"), "");
  EXPECT_EQ(noEffectNote(settings, "fabric.shear"), "");
  EXPECT_EQ(noEffectNote(settings, "stiffness"),
            "the setting 'stiffness' has no effect while material.model is fabric");
}

TEST(FabricSettings, refuseInvalidModuliWithTheNameOfTheSetting) {
  for (const char* key : {"fabric.stretch_warp", "fabric.stretch_weft", "fabric.shear", "fabric.stiffening_strain",
                          "fabric.stiffening_warp", "fabric.stiffening_weft", "fabric.bend_warp", "fabric.bend_weft",
                          "fabric.bend_bias", "fabric.density"}) {
    for (const char* value : {"-1", "-1e-9", "nan", "inf", "stiff"}) {
      const std::string message = refusal(std::string(key) + "=" + value);
      EXPECT_NE(message.find(std::string(key) + " must be"), std::string::npos) << key << "=" << value << message;
    }
    Settings settings;
    EXPECT_THROW(assignSetting(settings, requireSetting(key), std::numeric_limits<double>::quiet_NaN()),
                 messages::UsageError);
  }
  for (const char* key : {"fabric.stretch_warp", "fabric.stretch_weft", "fabric.shear", "fabric.density"}) {
    EXPECT_NE(refusal(std::string(key) + "=0"), "") << key;
  }
  EXPECT_NE(refusal("fabric.poisson=1").find("fabric.poisson must be -0.95 to 0.95"), std::string::npos);
  EXPECT_NE(refusal("fabric.warp_angle=91").find("fabric.warp_angle"), std::string::npos);
}

TEST(FabricSettings, refuseABiasThatBendsTooEasily) {
  const std::string message = refusal("fabric.bend_bias=1e-06");
  EXPECT_NE(message.find("fabric.bend_bias must be at least a quarter"), std::string::npos) << message;
  EXPECT_NE(message.find("1e-06 is not"), std::string::npos) << message;
  EXPECT_NE(refusal("fabric.bend_warp=0.001").find("fabric.bend_bias"), std::string::npos);
  EXPECT_EQ(refusal("fabric.bend_bias=4.5e-06"), "") << "a quarter of 10 and 8";
}

TEST(FabricSettings, areStableWithinTheirRanges) {
  Settings settings;
  for (const SettingInfo& info : settingsTable()) {
    const auto* number = std::get_if<NumberField>(&info.field);
    if (number == nullptr || !info.key.starts_with("fabric.")) {
      continue;
    }
    for (const double limit : {number->min, number->max}) {
      Settings changed = settings;
      assignSetting(changed, info, limit);
      bool accepted = true;
      try {
        requireConsistent(changed);
      } catch (const messages::UsageError&) {
        accepted = false;
      }
      EXPECT_EQ(accepted, sim::fabric::isStable(changed.fabric.moduli)) << info.key << " " << limit;
    }
  }
}

TEST(SettingsTable, takesFlagsInTheWordsPeopleUse) {
  Settings settings;
  for (const char* word : {"on", "true", "1", "yes"}) {
    settings.view.wireframe = false;
    assignSettingExpression(settings, std::string("view.wireframe=") + word);
    EXPECT_TRUE(settings.view.wireframe) << word;
  }
  assignSettingExpression(settings, "view.wireframe=off");
  EXPECT_FALSE(settings.view.wireframe);
  EXPECT_NE(refusal("view.wireframe=maybe"), "");
}

TEST(FormatValue, givesTheShortestTextThatReadsBackToTheSameBits) {
  EXPECT_EQ(formatValue(0.1), "0.1");
  EXPECT_EQ(formatValue(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(formatValue(7), "7");
  EXPECT_EQ(formatValue(true), "on");
}

}  // namespace
}  // namespace drape::settings
