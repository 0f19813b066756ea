// Every text of the window has its translation, and every translation its text. The tests of the panels
// (tests/ui/language_test.cpp) look at what is drawn; these read the sources.
#include "source_texts.hpp"

#include <toml++/toml.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

namespace drape::locale {
namespace {

const std::filesystem::path source = DRAPE_SOURCE;

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The entries of a catalogue: the English text, and its translation.
std::vector<std::pair<std::string, std::string>> entriesOf(const std::filesystem::path& file) {
  std::vector<std::pair<std::string, std::string>> entries;
  const toml::table table = toml::parse(contentOf(file));
  for (const auto& [english, translation] : *table["texts"].as_table()) {
    entries.emplace_back(english.str(), translation.value_or(std::string()));
  }
  return entries;
}

std::vector<std::filesystem::path> catalogues() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source / "assets" / "locale")) {
    files.push_back(entry.path());
  }
  return files;
}

/// Texts are compared without the case of their first letter and with blanks for "_": the window shows the words of
/// some tables so.
std::string plain(std::string text) {
  std::ranges::replace(text, '_', ' ');
  if (!text.empty()) {
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  }
  return text;
}

std::set<std::string> plainSet(const std::vector<std::string>& texts) {
  std::set<std::string> set;
  std::ranges::transform(texts, std::inserter(set, set.end()), plain);
  return set;
}

/// The titles and the helps of the built-in scenes.
std::vector<std::string> textsOfScenes() {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(source / "assets" / "scenes")) {
    const toml::table table = toml::parse(contentOf(entry.path()));
    texts.push_back(table["title"].value_or(std::string()));
    texts.push_back(table["help"].value_or(std::string()));
  }
  return texts;
}

/// Whether it is a sentence or a title, not a name, a format or a part of code.
bool isProse(const std::string& text) {
  const bool isCapital = std::isupper(static_cast<unsigned char>(text.front())) != 0;
  const bool hasWords = std::ranges::count(text, ' ') > 1 &&
                        std::ranges::any_of(text, [](unsigned char each) { return std::islower(each) != 0; });
  return isCapital && hasWords;
}

TEST(SourceTexts, FindTranslatedTexts) {
  const SourceTexts texts = textsOf(R"--(
    // texts("a comment")
    row(texts("one" /* "in between" */
              " and two"), 'x', "name");
    Sentence words(count == 1 ? "{} thing" : plural(count, "a\n", "\u00E4"), "an argument", Sentence("inner"));
    const int large = 1'000; char quote = '"'; other("text"); return Sentence{"last"};)--");
  EXPECT_EQ(texts.translated, (std::vector<std::string>{"one and two", "{} thing", "a\n", "\u00E4", "inner", "last"}));
  EXPECT_EQ(texts.all.size(), 9U);
}

bool hasLetters(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char each) { return std::isalpha(each) != 0; });
}

TEST(Catalogues, HaveEveryTextThatTheSourcesTranslate) {
  const SourceTexts texts = textsBelow(source / "src");
  ASSERT_GT(texts.translated.size(), 300U);
  for (const std::filesystem::path& file : catalogues()) {
    std::set<std::string> known;
    for (const auto& [english, translation] : entriesOf(file)) {
      known.insert(english);
    }
    for (const std::string& text : texts.translated) {
      EXPECT_TRUE(!hasLetters(text) || known.contains(text))
          << file.filename() << " has no entry for \"" << text << '"';
    }
  }
}

TEST(Catalogues, HaveEverySentenceOfThePanels) {
  // Keys, which keysInWords() translates.
  const std::set<std::string> unseen{"F5 to F8", "Ctrl+F5 to F8", "Ctrl+P   /", "Ctrl+Shift+Z   Ctrl+Y"};
  const SourceTexts texts = textsBelow(source / "src" / "ui");
  for (const std::filesystem::path& file : catalogues()) {
    std::set<std::string> known;
    for (const auto& [english, translation] : entriesOf(file)) {
      known.insert(english);
    }
    for (const std::string& text : texts.all) {
      if (!text.empty() && isProse(text) && !unseen.contains(text)) {
        EXPECT_TRUE(known.contains(text)) << file.filename() << " has no entry for \"" << text << '"';
      }
    }
  }
}

TEST(Catalogues, HaveEveryTextOfTheScenes) {
  for (const std::filesystem::path& file : catalogues()) {
    std::set<std::string> known;
    for (const auto& [english, translation] : entriesOf(file)) {
      known.insert(english);
    }
    for (const std::string& text : textsOfScenes()) {
      EXPECT_TRUE(text.empty() || known.contains(text)) << file.filename() << " has no entry for \"" << text << '"';
    }
  }
}

TEST(Catalogues, HaveNoEntryThatNothingUses) {
  std::set<std::string> used = plainSet(textsBelow(source / "src").all);
  used.merge(plainSet(textsOfScenes()));
  for (const std::filesystem::path& file : catalogues()) {
    const auto entries = entriesOf(file);
    EXPECT_GT(entries.size(), 900U);
    for (const auto& [english, translation] : entries) {
      EXPECT_TRUE(used.contains(plain(english))) << file.filename() << ": nothing uses \"" << english << '"';
      EXPECT_EQ(translation.find_first_not_of(' '), 0U) << file.filename() << ": \"" << english << '"';
      EXPECT_EQ(english.ends_with('.') && english.size() > 3, translation.ends_with('.') && translation.size() > 3)
          << file.filename() << ": the full stop at the end of \"" << english << '"';
    }
  }
}

}  // namespace
}  // namespace drape::locale
