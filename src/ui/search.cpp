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

/// Small letters, those of Latin-1 such as \u00E4 included. In UTF-8 they are two bytes of which the second one differs
/// by 0x20 from that of the capital letter.
std::string lowerCase(std::string text) {
  text = text::lowerCase(std::move(text));
  for (std::size_t i = 1; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    const bool isCapital = text[i - 1] == '\xC3' && letter >= 0x80U && letter <= 0x9EU && letter != 0x97U;
    text[i] = isCapital ? static_cast<char>(letter + 0x20U) : text[i];
  }
  return text;
}

std::string capitalised(std::string text) {
  if (text.empty()) {
    return text;
  }
  if (text[0] != '\xC3' || text.size() < 2) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  } else if (const auto letter = static_cast<unsigned char>(text[1]); letter >= 0xA0U && letter != 0xB7U) {
    text[1] = static_cast<char>(letter - 0x20U);
  }
  return text;
}

/// Whether it belongs to a word: a letter, a digit, or a part of a letter beyond ASCII.
bool isLetter(char each) {
  const auto byte = static_cast<unsigned char>(each);
  return byte >= 0x80U || std::isalnum(byte) != 0;
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

std::vector<SearchEntry> searchEntries(std::span<const scene::SceneInfo> scenes, std::span<const std::string> files,
                                       const text::Catalogue& texts) {
  std::vector<SearchEntry> entries;
  const auto add = [&](std::string_view title, std::string_view key, std::string_view help, auto target) {
    entries.push_back({texts(title), std::string(key), texts(help), target, std::string(title), std::string(help)});
  };
  for (const Shortcut& shortcut : shortcuts()) {
    if (!shortcut.help.empty()) {
      add(shortcut.help, shortcut.keys, {}, &shortcut);
      entries.back().title = capitalised(std::move(entries.back().title));
      entries.back().english = capitalised(std::move(entries.back().english));
    }
  }
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    add(info.title, info.key, info.help, &info);
  }
  for (const scene::SceneInfo& scene : scenes) {
    add(scene.title, scene.name, scene.help, SceneTarget{scene.name});
  }
  for (const std::string& file : files) {
    const std::string name = std::filesystem::path(file).filename().string();
    entries.push_back({name, file, {}, SceneTarget{file}, name, {}});
  }
  return entries;
}

std::optional<int> misfit(const SearchEntry& entry, std::string_view text) {
  struct Texts {
    std::string title;
    std::string help;
  };
  const std::string key = lowerCase(entry.key);
  std::vector<Texts> languages{{lowerCase(entry.title), lowerCase(entry.help)}};
  if (!entry.english.empty() && entry.english != entry.title) {
    languages.push_back({lowerCase(entry.english), lowerCase(entry.englishHelp)});
  }
  std::istringstream words(lowerCase(std::string(text)));
  constexpr int longest = 100;  // of the titles whose length counts
  int sum = 0;
  for (std::string word; words >> word;) {
    std::optional<int> best;
    for (const Texts& each : languages) {
      const std::optional<int> one = misfitOfWord(each.title, key, each.help, word);
      best = !best || (one && *one < *best) ? one : best;
    }
    if (!best) {
      return std::nullopt;
    }
    sum += *best * longest;
  }
  const bool hasWords = text.find_first_not_of(' ') != std::string_view::npos;
  return hasWords ? sum + std::min(static_cast<int>(languages.front().title.size()), longest - 1) : 0;
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
