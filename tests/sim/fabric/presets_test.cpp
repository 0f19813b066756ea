#include "sim/fabric/presets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace drape::sim::fabric {
namespace {

TEST(MaterialPresets, areStableAndNamedOnceWithTheirSource) {
  std::set<std::string_view> names;
  std::set<std::string_view> titles;
  for (const MaterialPreset& preset : presetTable()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_TRUE(titles.insert(preset.title).second) << preset.name;
    EXPECT_TRUE(isStable(preset.material)) << preset.name;
    EXPECT_TRUE(resistBending(preset.material)) << preset.name;
    EXPECT_GT(preset.source.size(), 20U) << preset.name;
  }
  for (const char* name : {"silk", "cotton", "denim", "canvas", "wool", "linen", "jersey", "nylon", "polyester", "felt",
                           "leather", "rubber"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(MaterialPresets, haveTheWeightAndThicknessOfCloth) {
  for (const MaterialPreset& preset : presetTable()) {
    EXPECT_GE(preset.density, 0.05) << preset.name;
    EXPECT_LE(preset.density, 1.0) << preset.name;
    EXPECT_GE(preset.thickness, 0.1e-3) << preset.name;
    EXPECT_LE(preset.thickness, 2e-3) << preset.name;
    const double perVolume = preset.density / preset.thickness;  // fibres have up to 1550 kg/m^3
    EXPECT_GE(perVolume, 100.0) << preset.name;
    EXPECT_LE(perVolume, 1550.0) << preset.name;
  }
}

TEST(MaterialPresets, haveTheFrictionOfCloth) {
  for (const MaterialPreset& preset : presetTable()) {
    EXPECT_GE(preset.friction.selfStatic, preset.friction.selfKinetic) << preset.name;
    EXPECT_GE(preset.friction.selfKinetic, 0.1) << preset.name;
    EXPECT_LE(preset.friction.selfStatic, 1.0) << preset.name;
    EXPECT_GE(preset.friction.skin, 0.2) << preset.name;
    EXPECT_LE(preset.friction.skin, 0.8) << preset.name;
  }
  EXPECT_DOUBLE_EQ(skinFrictionRatio(findPreset("cotton")->friction), 1.0);
  EXPECT_NEAR(skinFrictionRatio(findPreset("nylon")->friction), 0.37 / 0.51, 1e-12);  // Zhang and Mak 1999
}

TEST(MaterialPresets, haveTheBendingLengthOfCloth) {
  // Peirce's bending length, (B / weight per area)^(1/3): 1 cm for limp cloth, 5 cm for stiff cloth.
  for (const MaterialPreset& preset : presetTable()) {
    const double weight = preset.density * 9.81;
    for (const double bending : {preset.material.bendWarp, preset.material.bendWeft, preset.material.bendBias}) {
      const double length = std::cbrt(bending / weight);
      EXPECT_GT(length, 0.01) << preset.name;
      EXPECT_LT(length, 0.05) << preset.name;
    }
  }
}

TEST(MaterialPresets, haveTheValuesOfTheLiterature) {
  const MaterialPreset* denim = findPreset("denim");  // Wang et al. 2011
  ASSERT_NE(denim, nullptr);
  EXPECT_DOUBLE_EQ(denim->density, 0.324);
  EXPECT_DOUBLE_EQ(denim->material.stretchWarp, 205.0);
  EXPECT_DOUBLE_EQ(denim->material.stretchWeft, 1014.0);
  EXPECT_DOUBLE_EQ(denim->material.shear, 53.0);
  EXPECT_DOUBLE_EQ(denim->material.bendWarp, 64e-6);
  EXPECT_DOUBLE_EQ(denim->material.bendBias, 73e-6);
  EXPECT_DOUBLE_EQ(denim->material.bendWeft, 97e-6);
  const MaterialPreset* silk = findPreset("silk");  // Clyde et al. 2017
  ASSERT_NE(silk, nullptr);
  EXPECT_DOUBLE_EQ(silk->density, 0.083);
  EXPECT_DOUBLE_EQ(silk->material.stretchWarp, 1030.0);
  EXPECT_DOUBLE_EQ(silk->material.stretchWeft, 2380.0);
  EXPECT_DOUBLE_EQ(silk->material.shear, 136.0);
  EXPECT_EQ(findPreset("cardboard"), nullptr);
}

TEST(MaterialPresets, ofASheetHaveItsYoungsModulusAndPoissonsRatio) {
  const MaterialPreset* rubber = findPreset("rubber");
  ASSERT_NE(rubber, nullptr);
  const Material& sheet = rubber->material;
  EXPECT_NEAR(sheet.stretchWarp * (1.0 - sheet.poisson * sheet.poisson), 1.2e6 * 0.4e-3, 1e-9);
  EXPECT_NEAR(sheet.shear, 1.2e6 * 0.4e-3 / 3.0, 1e-9);
  EXPECT_NEAR(sheet.bendWarp, 1.2e6 * std::pow(0.4e-3, 3) / 12.0, 1e-15);
}

}  // namespace
}  // namespace drape::sim::fabric
