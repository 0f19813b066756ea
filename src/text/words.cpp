#include "text/words.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace drape::text {
namespace {

/// The Levenshtein distance between two words.
int editDistance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::string nearestWord(std::string_view mistyped, const std::vector<std::string>& words) {
  constexpr std::size_t fewLetters = 3;
  const std::string given = lowerCase(std::string(mistyped));
  const auto begun = std::ranges::find_if(
      words, [&](const std::string& word) { return given.size() >= fewLetters && lowerCase(word).starts_with(given); });
  if (begun != words.end()) {
    return *begun;
  }
  const auto distance = [&](const std::string& word) { return editDistance(given, lowerCase(word)); };
  const auto nearest = std::ranges::min_element(words, {}, distance);
  const int allowed = given.size() <= fewLetters ? 1 : std::max(2, static_cast<int>(given.size()) / 3);
  return nearest != words.end() && distance(*nearest) <= allowed ? *nearest : std::string();
}

}  // namespace drape::text
