#include "ui/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace drape::ui {
namespace {

class Search : public ::testing::Test {
 protected:
  /// The title of the best entry.
  std::string best(const std::string& text) const {
    const std::vector<std::size_t> found = findEntries(entries_, text);
    return found.empty() ? "" : entries_[found.front()].title;
  }
  bool finds(const std::string& text, const std::string& key) const {
    const std::vector<std::size_t> found = findEntries(entries_, text);
    return std::ranges::any_of(found, [&](std::size_t i) { return entries_[i].key == key; });
  }

  std::vector<std::string> files_{"/home/me/My shirt.obj"};
  std::vector<scene::SceneInfo> scenes_ = scene::sceneList();
  std::vector<SearchEntry> entries_ = searchEntries(scenes_, files_);
};

TEST_F(Search, HasEverySettingEverySceneAndEveryFile) {
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    EXPECT_TRUE(finds(std::string(info.key), std::string(info.key))) << info.key;
  }
  for (const scene::SceneInfo& scene : scenes_) {
    EXPECT_TRUE(finds(scene.title, scene.name)) << scene.name;
  }
  EXPECT_EQ(best("my shirt"), "My shirt.obj");
}

TEST_F(Search, HasEveryCommandOnce) {
  std::size_t named = 0;
  for (const Shortcut& shortcut : shortcuts()) {
    named += shortcut.help.empty() ? 0U : 1U;
  }
  const auto commands = std::ranges::count_if(
      entries_, [](const SearchEntry& entry) { return std::holds_alternative<const Shortcut*>(entry.target); });
  EXPECT_EQ(static_cast<std::size_t>(commands), named);
}

TEST_F(Search, PrefersTheStartOfAWordInTheTitle) {
  EXPECT_EQ(best("stiff"), "Stiffness");
  EXPECT_EQ(best("undo"), "Undo");
  EXPECT_EQ(best("wirefr"), "Wireframe");
}

TEST_F(Search, TakesWordsInAnyOrderAndAnyCase) {
  EXPECT_EQ(best("STEP time"), "Time step");
}

TEST_F(Search, TakesLettersThatAreSpreadOverTheTitle) {
  EXPECT_TRUE(finds("stfns", "stiffness"));
}

TEST_F(Search, TakesWordsOfTheExplanation) {
  EXPECT_TRUE(finds("simulated time of one step", "time_step"));
}

TEST_F(Search, FindsNothingForNonsense) {
  EXPECT_TRUE(findEntries(entries_, "xqzxqz").empty());
  EXPECT_EQ(findEntries(entries_, "  ").size(), entries_.size()) << "without a word all entries fit";
}

}  // namespace
}  // namespace drape::ui
