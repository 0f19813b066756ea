#pragma once

#include <string>
#include <string_view>

namespace drape {

/// A message of a library as part of a sentence: one line of at most 160 letters, without control characters and
/// without the stop at its end.
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

}  // namespace drape
