#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace drape::locale {

/// The texts of a source file in C++.
struct SourceTexts {
  std::vector<std::string> all;         ///< every string literal; adjacent ones are one
  std::vector<std::string> translated;  ///< those in the first argument of a translation: texts("..."), Sentence("...")
};

/// Reads the string literals of a source. It knows comments, characters and escapes, but no raw strings.
[[nodiscard]] SourceTexts textsOf(std::string_view source);

/// The sources below a folder, and everything in them.
[[nodiscard]] SourceTexts textsBelow(const std::filesystem::path& folder);

}  // namespace drape::locale
