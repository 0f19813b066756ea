#include "fabrics/presets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace drape::fabrics {
namespace {

TEST(Presets, areStableAndNamedOnceWithTheirSource) {
  std::set<std::string_view> names;
  std::set<std::string_view> titles;
  for (const Preset& preset : presetTable()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_TRUE(titles.insert(preset.title).second) << preset.name;
    EXPECT_TRUE(sim::fabric::isStable(preset.material)) << preset.name;
    EXPECT_TRUE(sim::fabric::resistBending(preset.material)) << preset.name;
    EXPECT_GT(preset.source.size(), 20U) << preset.name;
  }
  for (const char* name : {"silk", "cotton", "denim", "canvas", "wool", "linen", "jersey", "nylon", "polyester", "felt",
                           "leather", "rubber"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Presets, haveTheWeightAndThicknessOfCloth) {
  for (const Preset& preset : presetTable()) {
    EXPECT_GE(preset.density, 0.05) << preset.name;
    EXPECT_LE(preset.density, 1.0) << preset.name;
    EXPECT_GE(preset.thickness, 0.1e-3) << preset.name;
    EXPECT_LE(preset.thickness, 2e-3) << preset.name;
    const double perVolume = preset.density / preset.thickness;  // fibres have up to 1550 kg/m^3
    EXPECT_GE(perVolume, 100.0) << preset.name;
    EXPECT_LE(perVolume, 1550.0) << preset.name;
  }
}

TEST(Presets, haveTheFrictionOfCloth) {
  for (const Preset& preset : presetTable()) {
    EXPECT_GE(preset.friction.selfStatic, preset.friction.selfKinetic) << preset.name;
    EXPECT_GE(preset.friction.selfKinetic, 0.1) << preset.name;
    EXPECT_LE(preset.friction.selfStatic, 1.0) << preset.name;
    EXPECT_GE(preset.friction.skin, 0.2) << preset.name;
    EXPECT_LE(preset.friction.skin, 0.8) << preset.name;
  }
  EXPECT_DOUBLE_EQ(skinFrictionRatio(findPreset("cotton")->friction), 1.0);
  EXPECT_NEAR(skinFrictionRatio(findPreset("nylon")->friction), 0.37 / 0.51, 1e-12);  // Zhang and Mak 1999
}

TEST(Presets, haveTheBendingLengthOfCloth) {
  // Peirce's bending length, (B / weight per area)^(1/3): 1 cm for limp cloth, 5 cm for stiff cloth.
  for (const Preset& preset : presetTable()) {
    const double weight = preset.density * 9.81;
    for (const double bending : {preset.material.bendWarp, preset.material.bendWeft, preset.material.bendBias}) {
      const double length = std::cbrt(bending / weight);
      EXPECT_GT(length, 0.01) << preset.name;
      EXPECT_LT(length, 0.05) << preset.name;
    }
  }
}

TEST(Presets, haveTheValuesOfTheLiterature) {
  const Preset* denim = findPreset("denim");  // Wang et al. 2011
  ASSERT_NE(denim, nullptr);
  EXPECT_DOUBLE_EQ(denim->density, 0.324);
  EXPECT_DOUBLE_EQ(denim->material.stretchWarp, 205.0);
  EXPECT_DOUBLE_EQ(denim->material.stretchWeft, 1014.0);
  EXPECT_DOUBLE_EQ(denim->material.shear, 53.0);
  EXPECT_DOUBLE_EQ(denim->material.bendWarp, 64e-6);
  EXPECT_DOUBLE_EQ(denim->material.bendBias, 73e-6);
  EXPECT_DOUBLE_EQ(denim->material.bendWeft, 97e-6);
  const Preset* silk = findPreset("silk");  // Clyde et al. 2017
  ASSERT_NE(silk, nullptr);
  EXPECT_DOUBLE_EQ(silk->density, 0.083);
  EXPECT_DOUBLE_EQ(silk->material.stretchWarp, 1030.0);
  EXPECT_DOUBLE_EQ(silk->material.stretchWeft, 2380.0);
  EXPECT_DOUBLE_EQ(silk->material.shear, 136.0);
  EXPECT_EQ(findPreset("cardboard"), nullptr);
}

TEST(Presets, ofASheetHaveItsYoungsModulusAndPoissonsRatio) {
  const Preset* rubber = findPreset("rubber");
  ASSERT_NE(rubber, nullptr);
  const sim::fabric::Material& sheet = rubber->material;
  EXPECT_NEAR(sheet.stretchWarp * (1.0 - sheet.poisson * sheet.poisson), 1.2e6 * 0.4e-3, 1e-9);
  EXPECT_NEAR(sheet.shear, 1.2e6 * 0.4e-3 / 3.0, 1e-9);
  EXPECT_NEAR(sheet.bendWarp, 1.2e6 * std::pow(0.4e-3, 3) / 12.0, 1e-15);
}

TEST(Presets, ofLeatherBendsMoreEasilyThanAHomogeneousSheet) {
  const Preset* leather = findPreset("leather");
  ASSERT_NE(leather, nullptr);
  const double sheet = 5e6 * std::pow(0.9e-3, 3) / 12.0;
  EXPECT_LT(leather->material.bendWarp, 0.5 * sheet);
  const double length = std::cbrt(leather->material.bendWarp / (leather->density * 9.81));
  EXPECT_NEAR(length, 0.019, 0.0005) << "of leather with its usual drape coefficient";
}

TEST(Presets, haveALookInRange) {
  for (const Preset& preset : presetTable()) {
    const Look& look = preset.look;
    for (const Colour& colour : {look.warp, look.weft}) {
      EXPECT_TRUE(std::all_of(colour.begin(), colour.end(), [](float part) { return part >= 0.0F && part <= 1.0F; }))
          << preset.name;
    }
    EXPECT_NE(look.warp, Colour()) << preset.name << " has a look of its own";
    EXPECT_GE(look.weave.repeat, 2) << preset.name;
    EXPECT_LT(look.weave.weftOnTop, static_cast<float>(look.weave.repeat)) << preset.name;
    EXPECT_GT(look.columns, 100.0F) << preset.name;
    EXPECT_LT(look.columns, 20000.0F) << preset.name;
    EXPECT_GT(look.roughness, 0.05F) << preset.name;
    EXPECT_LE(look.roughness, 1.0F) << preset.name;
  }
}

TEST(Presets, haveARangeOfTheDrapeCoefficientWithItsSourceOrNone) {
  for (const Preset& preset : presetTable()) {
    if (preset.drape) {
      EXPECT_GE(preset.drape->lower, 0.0) << preset.name;
      EXPECT_LE(preset.drape->upper, 100.0) << preset.name;
      EXPECT_LT(preset.drape->lower, preset.drape->upper) << preset.name;
      EXPECT_EQ(preset.drape->estimated, preset.drape->source.starts_with("Estimate")) << preset.name;
      EXPECT_GT(preset.drape->source.size(), 20U) << preset.name;
    }
  }
  EXPECT_EQ(findPreset("silk")->drape->upper, 40.0);
  EXPECT_FALSE(findPreset("rubber")->drape.has_value());
}

}  // namespace
}  // namespace drape::fabrics
