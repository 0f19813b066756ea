// Scenes and cloths in the sentences of the window.
#include "ui/names_in_words.hpp"
#include "locale/language.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

std::string german(const text::Sentence& sentence) {
  return locale::findLanguage("de")->texts(sentence);
}

TEST(NamesInWords, ABuiltInSceneHasItsTranslatedTitle) {
  const scene::SceneDescription cape = scene::openScene("cape");
  EXPECT_EQ(inWords(cape), "A cape among posts");
  EXPECT_EQ(inWords(cape.parts), "A cape among posts");
  EXPECT_EQ(german(inWords(cape)), "Ein Umhang zwischen Pfosten");
  EXPECT_EQ(german(text::Sentence("Opened '{}'", inWords(cape))), "'Ein Umhang zwischen Pfosten' geöffnet");
}

TEST(NamesInWords, AFileHasItsName) {
  scene::SceneDescription description;
  description.name = "shirt.obj";
  EXPECT_EQ(german(inWords(description)), "shirt.obj");
  EXPECT_EQ(german(inWords(scene::SceneParts{.scene = "/tmp/shirt.obj"})), "/tmp/shirt.obj");
  EXPECT_EQ(german(inWords(scene::SceneParts{.scene = "cape", .cloth = "coat.obj"})), "coat.obj");
}

TEST(NamesInWords, AClothWithoutANameIsTheCloth) {
  scene::SceneDescription description;
  EXPECT_EQ(inWords(description, {}), "the cloth");
  EXPECT_EQ(german(inWords(description, {})), "das Tuch");
  description.cloths.front().name = "runner";
  EXPECT_EQ(german(inWords(description, {})), "runner");
}

}  // namespace
}  // namespace drape::ui
