#include "messages/length_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::messages {

using text::Sentence;

std::string brief(double value) {
  const double size = value > 0.0 ? std::floor(std::log10(value)) : 0.0;
  const int decimals = std::clamp(1 - static_cast<int>(size), 0, 9);
  std::string words = fmt::format("{:.{}f}", value, decimals);
  if (words.find('.') != std::string::npos) {
    words.erase(words.find_last_not_of('0') + 1);
    if (words.back() == '.') {
      words.pop_back();
    }
  }
  return words;
}

Sentence lengthInWords(double metres) {
  constexpr double shortest = 1e-9;
  if (metres < shortest) {
    return Sentence("below 1 nm");
  }
  if (metres < 1e-6) {
    return Sentence("about {} nm", brief(metres * 1e9));
  }
  if (metres < 1e-4) {
    return Sentence("about {} \u00B5m", brief(metres * 1e6));
  }
  return metres < 0.1 ? Sentence("about {} mm", brief(metres * 1e3)) : Sentence("about {} m", brief(metres));
}

}  // namespace drape::messages
