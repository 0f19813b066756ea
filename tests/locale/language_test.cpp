#include "locale/language.hpp"

#include "messages/error.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace drape::locale {
namespace {

/// What is wrong with a catalogue; empty if nothing is.
std::string problemOf(const std::string& toml) {
  try {
    static_cast<void>(parseLanguage(toml, "xx", "xx.toml"));
    return {};
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

bool hasWords(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(Language, EnglishComesFirstAndGermanIsEmbedded) {
  ASSERT_GE(languages().size(), 2U);
  EXPECT_EQ(languages().front().name, "en");
  EXPECT_EQ(languages().front().texts("Stiffness"), "Stiffness");
  const Language* german = findLanguage("de");
  ASSERT_NE(german, nullptr);
  EXPECT_EQ(german->title, "Deutsch");
  EXPECT_EQ(german->texts("Stiffness"), "Steifigkeit");
  EXPECT_EQ(findLanguage("xx"), nullptr);
}

TEST(Language, FollowsTheLocaleOfTheSystem) {
  for (const char* locale : {"de", "de_DE.UTF-8", "de_AT", "de_CH.ISO-8859-1", "de@euro"}) {
    EXPECT_EQ(languageOfLocale(locale).name, "de") << locale;
  }
  for (const char* locale : {"", "C", "C.UTF-8", "POSIX", "en_GB.UTF-8", "fr_FR.UTF-8", "deu", "d"}) {
    EXPECT_EQ(languageOfLocale(locale).name, "en") << locale;
  }
}

TEST(Language, AnUnknownNameIsRefusedWithTheKnownOnes) {
  try {
    static_cast<void>(openLanguage("klingon"));
    FAIL() << "there is no such language";
  } catch (const messages::UsageError& error) {
    EXPECT_TRUE(hasWords(error.what(), "'klingon'")) << error.what();
    EXPECT_TRUE(hasWords(error.what(), "en (English), de (Deutsch)")) << error.what();
  }
  EXPECT_EQ(openLanguage("de").title, "Deutsch");
}

TEST(Language, OpensACatalogueOfTheUser) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "drape-xx-test.toml";
  std::ofstream(file) << "title = \"Own\"\n[texts]\n\"Play\" = \"Go\"\n";
  const Language own = openLanguage(file.string());
  EXPECT_EQ(own.name, "drape-xx-test");
  EXPECT_EQ(own.title, "Own");
  EXPECT_EQ(own.texts("Play"), "Go");
  EXPECT_EQ(own.texts("Pause"), "Pause");
  std::filesystem::remove(file);
  EXPECT_THROW(static_cast<void>(openLanguage(file.string())), messages::InputError);
}

TEST(Language, ReportsTheLineOfAWrongCatalogue) {
  EXPECT_EQ(problemOf("title = \"X\"\n[texts]\n\"a {} b {}\" = \"{1}, {0}\"\n"), "");
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a {}\" = \"b\"\n"), "xx.toml:3: "));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a {}\" = \"{} {}\"\n"), "same placeholders"));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a {}\" = \"{1}\"\n"), "same placeholders"));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a\" = 3\n"), "is no text"));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a\" = \"\"\n"), "is no text"));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n[texts]\n\"a\" = \"b\"\n\"a\" = \"c\"\n"), "xx.toml:4: "));
  EXPECT_TRUE(hasWords(problemOf("[texts]\n"), "needs a title"));
  EXPECT_TRUE(hasWords(problemOf("title = \"X\"\n"), "[texts]"));
  EXPECT_TRUE(hasWords(problemOf("title = "), "not valid TOML"));
}

}  // namespace
}  // namespace drape::locale
