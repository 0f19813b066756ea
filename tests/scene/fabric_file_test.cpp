#include "scene/fabric_file.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "scene/scene_file.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>

namespace drape::scene {
namespace {

std::string refusalOfList(std::string_view text) {
  try {
    static_cast<void>(parseFabrics(text, "mine.toml"));
    return "";
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

settings::OwnFabric silkCalled(const std::string& name) {
  settings::Settings settings;
  settings::assignSettingExpression(settings, "material.preset=silk");
  return settings::fabricOf(settings, name);
}

constexpr const char* softDenim = "[[fabrics]]\nname = \"Soft denim\"\nbased_on = \"denim\"\nshear = 40\n";

TEST(FabricFile, fillsTheGapsFromTheFabricThatItIsBasedOn) {
  const settings::OwnFabrics fabrics = parseFabrics(softDenim, "mine.toml");
  ASSERT_EQ(fabrics->size(), 1U);
  EXPECT_EQ(fabrics->front().material.shear, 40.0);
  EXPECT_EQ(fabrics->front().material.stretchWeft, fabrics::findPreset("denim")->material.stretchWeft);
  EXPECT_EQ(fabrics->front().basedOn, "denim");
  EXPECT_EQ(parseFabrics("", "mine.toml"), nullptr);
}

TEST(FabricFile, namesFileLineFabricAndRemedyOfWhatItRefuses) {
  for (const auto& [text, place, expected] :
       {std::tuple("[[fabrics]]\nname = \"a\"\nshear = 40\n", "mine.toml:1: the fabric \"a\"", "density is missing"),
        std::tuple("[[fabrics]]\nbased_on = \"denim\"\n", "mine.toml:1: the fabric \"\"", "needs a name"),
        std::tuple("[[fabrics]]\nname = \"Denim\"\nbased_on = \"denim\"\n", "mine.toml:1:", "built-in fabric Denim"),
        std::tuple("\n[[fabrics]]\nname = \"a\"\nbased_on = \"wool 2\"\n", "mine.toml:2:", "'wool 2' is not"),
        std::tuple("[[fabrics]]\nname = \"a\"\nbased_on = \"denim\"\nshear = -1\n", "the fabric \"a\"",
                   "fabric.shear must be 0.1"),
        std::tuple("[[fabrics]]\nname = \"a\"\nbased_on = \"denim\"\nshear = nan\n", "the fabric \"a\"",
                   "fabric.shear must be 0.1"),
        std::tuple("[[fabrics]]\nname = \"a\"\nbased_on = \"denim\"\nshear = \"x\"\n", "the fabric \"a\"",
                   "fabric.shear must be 0.1"),
        std::tuple("[[fabrics]]\nname = \"a\"\nbased_on = \"denim\"\nbend_bias = 0\n", "the fabric \"a\"",
                   "fabric.bend_bias must be at least"),
        std::tuple("[[fabrics]]\nname = \"a\"\nbased_on = \"denim\"\ncolour = 3\n", "mine.toml:4", "'fabrics.colour'"),
        std::tuple("[[fabrics]]\nname = 3\n", "mine.toml:2", "fabrics.name must be a text"),
        std::tuple("fabrics = 3\n", "mine.toml:1", "fabrics"), std::tuple("fabric = 3\n", "mine.toml:1", "'fabric'"),
        std::tuple("[[fabrics]\n", "mine.toml:1", "not valid TOML")}) {
    const std::string message = refusalOfList(text);
    EXPECT_NE(message.find(place), std::string::npos) << message;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
  EXPECT_NE(refusalOfList(std::string(softDenim) + softDenim).find("mine.toml:5: there are two fabrics"),
            std::string::npos);
}

TEST(FabricFile, addsAFabricAndKeepsTheRestOfTheText) {
  const std::string before = "# My fabrics\n" + std::string(softDenim) + "# the end";
  const std::string text = withFabricEntry(before, silkCalled("My \"silk\""), "mine.toml");
  EXPECT_TRUE(text.starts_with(before)) << text;
  const settings::OwnFabrics fabrics = parseFabrics(text, "mine.toml");
  ASSERT_EQ(fabrics->size(), 2U);
  EXPECT_EQ((*fabrics)[1], silkCalled("My \"silk\"")) << "the values come back to the last bit";
  EXPECT_EQ(parseFabrics(withFabricEntry("", silkCalled("a"), "mine.toml"), "mine.toml")->size(), 1U);
}

TEST(FabricFile, replacesAFabricAndKeepsItsNeighboursAndComments) {
  const std::string before =
      "# first\n" + std::string(softDenim) + "\n# second\n[[fabrics]]\nname = \"b\"\n" + "based_on = \"wool\" # warm\n";
  const std::string text = withFabricEntry(before, silkCalled("Soft denim"), "mine.toml");
  EXPECT_TRUE(text.starts_with("# first\n[[fabrics]]\nname = ")) << text;
  EXPECT_TRUE(text.ends_with("\n# second\n[[fabrics]]\nname = \"b\"\nbased_on = \"wool\" # warm\n")) << text;
  const settings::OwnFabrics fabrics = parseFabrics(text, "mine.toml");
  ASSERT_EQ(fabrics->size(), 2U);
  EXPECT_EQ((*fabrics)[0], silkCalled("Soft denim"));
}

TEST(FabricFile, refusesToExtendAFormThatItCannotKeep) {
  const std::string inlineForm =
      "fabrics = [{ name = \"a\", based_on = \"denim\" }, { name = \"c\", based_on = \"silk\" }]\n";
  EXPECT_EQ(parseFabrics(inlineForm, "mine.toml")->size(), 2U);
  for (const char* name : {"a", "b"}) {
    EXPECT_THROW(static_cast<void>(withFabricEntry(inlineForm, silkCalled(name), "mine.toml")), messages::InputError);
  }
  EXPECT_THROW(static_cast<void>(withFabricEntry("[[fabrics]\n", silkCalled("a"), "mine.toml")), messages::InputError);
}

TEST(FabricFile, canBePartOfAScene) {
  const std::string scene =
      "[cloth]\ngrid = \"vertical\"\n[settings]\nmaterial.model = \"fabric\"\n"
      "material.preset = \"Soft denim\"\n";
  EXPECT_THROW(static_cast<void>(parseScene(scene, "s", "s.toml", {})), messages::InputError);
  const SceneDescription withOwn = parseScene(scene + softDenim, "s", "s.toml", {});
  EXPECT_EQ(settings::fabricTitle(withOwn.settings), "Soft denim");
  EXPECT_EQ(withOwn.settings.fabric.moduli.shear, 40.0);
  // The fabric of the scene wins over that of the user.
  const SceneDescription both =
      parseScene(scene + softDenim, "s", "s.toml", {}, settings::withOwnFabric({}, silkCalled("Soft denim")));
  EXPECT_EQ(both.settings.fabric.moduli.shear, 40.0);
  const SceneDescription users =
      parseScene(scene, "s", "s.toml", {}, settings::withOwnFabric({}, silkCalled("Soft denim")));
  EXPECT_EQ(users.settings.fabric.moduli, silkCalled("x").material);
  const std::string extended = withFabricEntry(scene, silkCalled("b"), "s.toml");
  EXPECT_TRUE(extended.starts_with(scene)) << extended;
}

}  // namespace
}  // namespace drape::scene
