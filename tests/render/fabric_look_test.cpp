#include "render/fabric_look.hpp"
#include "fabrics/presets.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>
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

TEST(FabricLook, PresetsLookLikeTheirRow) {
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    settings::Settings settings;
    settings::assignSettingExpression(settings, "material.preset=" + std::string(preset.name));
    EXPECT_EQ(&lookOf(settings), &preset.look) << preset.name;
  }
}

TEST(FabricLook, AnOwnFabricHasTheLookOfItsBase) {
  settings::Settings settings = settingsWith({"material.preset=denim", "fabric.shear=80"});
  settings.fabric.own = settings::withOwnFabric({}, settings::fabricOf(settings, "mine"));
  settings::assignSettingExpression(settings, "material.preset=silk");
  settings::assignSettingExpression(settings, "material.preset=mine");
  EXPECT_EQ(lookedLike(settings).name, "denim");
}

TEST(FabricLook, ACustomFabricLooksLikeTheMostSimilarPreset) {
  EXPECT_EQ(lookedLike(settingsWith({"material.preset=leather", "material.preset=custom", "fabric.density=0.5"})).name,
            "leather");
}

TEST(FabricLook, AChangedPresetKeepsItsLook) {
  EXPECT_EQ(lookedLike(settingsWith({"material.preset=denim", "fabric.shear=80", "fabric.bend_bias=1e-4"})).name,
            "denim");
  EXPECT_EQ(lookedLike(settingsWith({"material.preset=leather", "fabric.density=0.5"})).name, "leather");
  EXPECT_EQ(lookedLike(settingsWith({"material.preset=silk", "fabric.bend_warp=0", "fabric.bend_weft=0"})).name,
            "silk");
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
