#include "render/fabric_look.hpp"
#include "settings/settings_table.hpp"
#include "sim/fabric/presets.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>

namespace drape::render {
namespace {

settings::Settings settingsWith(std::initializer_list<const char*> expressions) {
  settings::Settings settings;
  for (const char* expression : expressions) {
    settings::assignSettingExpression(settings, expression);
  }
  return settings;
}

TEST(FabricLook, EveryPresetHasOneRow) {
  const auto looks = fabricLooks();
  for (const sim::fabric::MaterialPreset& preset : sim::fabric::presetTable()) {
    EXPECT_EQ(std::count_if(looks.begin(), looks.end(), [&](const auto& look) { return look.preset == preset.name; }),
              1)
        << preset.name;
  }
  EXPECT_EQ(looks.size(), sim::fabric::presetTable().size());
}

TEST(FabricLook, PresetsLookLikeTheirRow) {
  for (const sim::fabric::MaterialPreset& preset : sim::fabric::presetTable()) {
    settings::Settings settings;
    settings::assignSettingExpression(settings, "material.preset=" + std::string(preset.name));
    EXPECT_EQ(lookOf(settings).preset, preset.name);
  }
}

TEST(FabricLook, AnOwnFabricHasTheLookOfItsBase) {
  settings::Settings settings = settingsWith({"material.preset=denim", "fabric.shear=80"});
  settings.fabric.own = settings::withOwnFabric({}, settings::fabricOf(settings, "mine"));
  settings::assignSettingExpression(settings, "material.preset=silk");
  settings::assignSettingExpression(settings, "material.preset=mine");
  EXPECT_EQ(lookOf(settings).preset, "denim");
}

TEST(FabricLook, ACustomFabricLooksLikeTheMostSimilarPreset) {
  EXPECT_EQ(lookOf(settingsWith({"material.preset=leather", "material.preset=custom", "fabric.density=0.5"})).preset,
            "leather");
}

TEST(FabricLook, AChangedPresetKeepsItsLook) {
  EXPECT_EQ(lookOf(settingsWith({"material.preset=denim", "fabric.shear=80", "fabric.bend_bias=1e-4"})).preset,
            "denim");
  EXPECT_EQ(lookOf(settingsWith({"material.preset=leather", "fabric.density=0.5"})).preset, "leather");
  EXPECT_EQ(lookOf(settingsWith({"material.preset=silk", "fabric.bend_warp=0", "fabric.bend_weft=0"})).preset, "silk");
}

TEST(FabricLook, ValuesAreInRange) {
  for (const FabricLook& look : fabricLooks()) {
    for (const Colour& colour : {look.warp, look.weft}) {
      EXPECT_TRUE(std::all_of(colour.begin(), colour.end(), [](float part) { return part >= 0.0F && part <= 1.0F; }));
    }
    EXPECT_GE(look.weave.repeat, 2);
    EXPECT_LT(look.weave.weftOnTop, static_cast<float>(look.weave.repeat));
    EXPECT_GT(look.columns, 100.0F);
    EXPECT_LT(look.columns, 20000.0F);
    EXPECT_GT(look.roughness, 0.05F);
    EXPECT_LE(look.roughness, 1.0F);
  }
}

TEST(FabricLook, AutomaticSurfaceFollowsTheMaterial) {
  EXPECT_EQ(surfaceOf(settings::Settings()), Surface::Checker);
  EXPECT_EQ(surfaceOf(settingsWith({"material.model=fabric"})), Surface::Fabric);
  EXPECT_EQ(surfaceOf(settingsWith({"view.surface=fabric"})), Surface::Fabric);
  EXPECT_EQ(surfaceOf(settingsWith({"material.model=fabric", "view.surface=checker"})), Surface::Checker);
  EXPECT_EQ(surfaceOf(settingsWith({"material.model=fabric", "view.surface=plain"})), Surface::Plain);
}

}  // namespace
}  // namespace drape::render
