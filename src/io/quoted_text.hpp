#pragma once

#include <string>
#include <string_view>

namespace drape::io {

/// A word from a file in quotes, for a message: shortened, without bytes that could confuse a terminal.
[[nodiscard]] inline std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char letter : word.substr(0, longest)) {
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return text + (word.size() > longest ? "...'" : "'");
}

}  // namespace drape::io
