#pragma once

#include <string>
#include <string_view>

namespace drape::io {

/// A library's message as part of a sentence: one line of at most 160 characters, without control characters and
/// without the final full stop.
[[nodiscard]] inline std::string oneLine(std::string_view message) {
  constexpr std::size_t longest = 160;
  std::string line;
  for (const char letter : message.substr(0, longest)) {
    line += letter >= ' ' && letter <= '~' ? letter : letter == '\n' || letter == '\t' ? ' ' : '?';
  }
  if (message.size() > longest) {
    return line + "...";
  }
  line.erase(line.find_last_not_of(". ") + 1);
  return line;
}

}  // namespace drape::io
