#include "ui/search.hpp"

#include "text/words.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <utility>

namespace drape::ui {
namespace {

// The misfit of a word, by the place where it occurs.
constexpr int startsWord = 0;
constexpr int insideTitle = 2;
constexpr int insideKey = 3;
constexpr int spread = 6;
constexpr int insideHelp = 8;

std::string capitalised(std::string_view text) {
  std::string result(text);
  if (!result.empty()) {
    result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  }
  return result;
}

bool isLetter(char each) {
  return std::isalnum(static_cast<unsigned char>(each)) != 0;
}

bool startsWordOf(const std::string& title, const std::string& word) {
  for (std::size_t at = title.find(word); at != std::string::npos; at = title.find(word, at + 1)) {
    if (at == 0 || !isLetter(title[at - 1])) {
      return true;
    }
  }
  return false;
}

/// Whether the letters occur in this order, as in "stf" for "stiffness".
bool isSpreadOver(const std::string& title, const std::string& word) {
  constexpr std::size_t fewLetters = 3;  // fewer occur in nearly every title
  std::size_t at = 0;
  for (const char letter : word) {
    at = title.find(letter, at);
    if (at == std::string::npos) {
      return false;
    }
    ++at;
  }
  return word.size() >= fewLetters && !title.empty() && word.front() == title.front();
}

std::optional<int> misfitOfWord(const std::string& title, const std::string& key, const std::string& help,
                                const std::string& word) {
  if (startsWordOf(title, word)) {
    return startsWord;
  }
  if (title.find(word) != std::string::npos) {
    return insideTitle;
  }
  if (key.find(word) != std::string::npos) {
    return insideKey;
  }
  if (isSpreadOver(title, word)) {
    return spread;
  }
  return help.find(word) != std::string::npos ? std::optional(insideHelp) : std::nullopt;
}

}  // namespace

std::vector<SearchEntry> searchEntries(std::span<const scene::SceneInfo> scenes, std::span<const std::string> files) {
  std::vector<SearchEntry> entries;
  for (const Shortcut& shortcut : shortcuts()) {
    if (!shortcut.help.empty()) {
      entries.push_back({capitalised(shortcut.help), std::string(shortcut.keys), {}, &shortcut});
    }
  }
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    entries.push_back({std::string(info.title), std::string(info.key), std::string(info.help), &info});
  }
  for (const scene::SceneInfo& scene : scenes) {
    entries.push_back({scene.title, scene.name, scene.help, SceneTarget{scene.name}});
  }
  for (const std::string& file : files) {
    entries.push_back({std::filesystem::path(file).filename().string(), file, {}, SceneTarget{file}});
  }
  return entries;
}

std::optional<int> misfit(const SearchEntry& entry, std::string_view text) {
  const std::string title = text::lowerCase(entry.title);
  const std::string key = text::lowerCase(entry.key);
  const std::string help = text::lowerCase(entry.help);
  std::istringstream words(text::lowerCase(std::string(text)));
  constexpr int longest = 100;  // of the titles whose length counts
  int sum = 0;
  for (std::string word; words >> word;) {
    const std::optional<int> one = misfitOfWord(title, key, help, word);
    if (!one) {
      return std::nullopt;
    }
    sum += *one * longest;
  }
  const bool hasWords = text.find_first_not_of(' ') != std::string_view::npos;
  return hasWords ? sum + std::min(static_cast<int>(title.size()), longest - 1) : 0;
}

std::vector<std::size_t> findEntries(std::span<const SearchEntry> entries, std::string_view text) {
  std::vector<std::pair<int, std::size_t>> found;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (const std::optional<int> bad = misfit(entries[i], text)) {
      found.emplace_back(*bad, i);
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<int, std::size_t>::first);
  std::vector<std::size_t> order;
  order.reserve(found.size());
  for (const auto& [bad, index] : found) {
    order.push_back(index);
  }
  return order;
}

}  // namespace drape::ui
