#include "text/sentence.hpp"
#include "text/catalogue.hpp"

#include <gtest/gtest.h>

namespace drape::text {
namespace {

Catalogue german() {
  return Catalogue({{"{} is {} m long", "{1} m ist die Länge von {0}"},
                    {"the {} of {}", "{} von {}"},
                    {"sleeve", "Ärmel"},
                    {"one", "eins"},
                    {"camera|Frame", "Einpassen"},
                    {"frame|Frame", "Bild"}});
}

TEST(Sentence, FillsItsPlaceholdersInOrder) {
  const Sentence sentence("{} is {} m long", "rod", 3);
  EXPECT_EQ(sentence.english(), "rod is 3 m long");
  EXPECT_EQ(sentence, "rod is 3 m long");
  EXPECT_NE(sentence, "rod is 4 m long");
}

TEST(Sentence, LeavesOtherBracesAndMissingArgumentsAlone) {
  EXPECT_EQ(Sentence("{frame:4} in it, {} of {}", 2).english(), "{frame:4} in it, 2 of ");
  EXPECT_EQ(Sentence("without arguments {}").english(), "without arguments {}");
  EXPECT_EQ(Sentence::verbatim("{} | {0}").english(), "{} | {0}");
}

TEST(Sentence, PutsTextsBetweenPartsThatExist) {
  Sentence words;
  EXPECT_TRUE(words.empty());
  words.append(", ", Sentence("one")).append(", ", Sentence()).append("; ", Sentence("two"));
  EXPECT_EQ(words, "one; two");
  words.append(", ", words);
  EXPECT_EQ(words, "one; two, one; two");
}

TEST(Sentence, ComparesTemplatesAndArguments) {
  EXPECT_EQ(Sentence("{} of {}", 1, 2), Sentence("{} of {}", 1, 2));
  EXPECT_FALSE(Sentence("{} of {}", 1, 2) == Sentence("{} of {}", 2, 1));
}

TEST(Sentence, ListsItsPlaceholders) {
  EXPECT_EQ(placeholdersOf("{} of {}"), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(placeholdersOf("{1} von {0}, {frame:4}"), (std::vector<std::size_t>{1, 0}));
  EXPECT_TRUE(placeholdersOf("none").empty());
}

TEST(Catalogue, TranslatesTheTemplateAndItsSentencesButNoNames) {
  const Catalogue texts = german();
  EXPECT_EQ(texts("{} is {} m long", "sleeve", 2), "2 m ist die Länge von sleeve");
  EXPECT_EQ(texts(Sentence("the {} of {}", Sentence("sleeve"), "sleeve")), "Ärmel von sleeve");
  Sentence both("one");
  EXPECT_EQ(texts(both.append("; ", Sentence("sleeve"))), "eins; Ärmel");
}

TEST(Catalogue, TellsMeaningsOfAWordApart) {
  EXPECT_EQ(german()("camera|Frame"), "Einpassen");
  EXPECT_EQ(german()("frame|Frame"), "Bild");
  EXPECT_EQ(Catalogue()("camera|Frame"), "Frame");
  EXPECT_EQ(Catalogue()("cannot read a|b.obj"), "cannot read a|b.obj") << "a bar in the name of a file";
}

TEST(Catalogue, StaysEnglishWithoutAnEntryAndReportsIt) {
  std::set<std::string> missing;
  Catalogue texts = german();
  texts.reportMissing(&missing);
  EXPECT_EQ(texts("the hem"), "the hem");
  EXPECT_EQ(texts("one"), "eins");
  EXPECT_EQ(texts(""), "");
  EXPECT_EQ(missing, std::set<std::string>{"the hem"});
}

}  // namespace
}  // namespace drape::text
