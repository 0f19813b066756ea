#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape::text {

/// The text with its ASCII letters in lower case.
[[nodiscard]] std::string lowerCase(std::string text);

/// The most similar word for a mistyped one: a word that starts with it, or one that differs in a few letters. Case
/// does not count. Empty when no word is similar.
[[nodiscard]] std::string nearestWord(std::string_view mistyped, const std::vector<std::string>& words);

}  // namespace drape::text
