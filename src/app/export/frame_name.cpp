#include "app/export/frame_name.hpp"

#include "messages/error.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>

namespace drape::app {
namespace {

constexpr int maxDigits = 9;

[[noreturn]] void refuse(std::string_view option, std::string_view pattern, const std::string& why) {
  const std::size_t dot = std::min(pattern.rfind('.'), pattern.size());
  throw messages::UsageError(std::string(option) + " '" + std::string(pattern) + "': " + why +
                             "; for example out/frame_{frame:4}" + std::string(pattern.substr(dot)));
}

/// The number of digits in "frame" or "frame:4"; -1 for any other word.
int digitsOf(std::string_view word) {
  constexpr std::string_view keyword = "frame";
  if (!word.starts_with(keyword)) {
    return -1;
  }
  word.remove_prefix(keyword.size());
  if (word.empty()) {
    return 1;
  }
  const bool oneDigit = word.size() == 2 && word[0] == ':' && std::isdigit(static_cast<unsigned char>(word[1])) != 0;
  const int digits = oneDigit ? word[1] - '0' : -1;
  return digits >= 1 && digits <= maxDigits ? digits : -1;
}

}  // namespace

FramePattern::FramePattern(std::string_view pattern, int frames, std::string_view option) {
  const auto open = pattern.find('{');
  if (open == std::string_view::npos) {
    if (frames > 1) {
      refuse(option, pattern, "several frames need a placeholder for their number");
    }
    before_ = pattern;
    return;
  }
  const auto close = pattern.find('}', open);
  digits_ = close == std::string_view::npos ? -1 : digitsOf(pattern.substr(open + 1, close - open - 1));
  if (digits_ < 0) {
    refuse(option, pattern, "the placeholder for the number is {frame} or {frame:DIGITS}, with 1 to 9 digits");
  }
  before_ = pattern.substr(0, open);
  after_ = pattern.substr(close + 1);
  numbered_ = true;
}

std::string FramePattern::name(int frame) const {
  if (!numbered_) {
    return before_;
  }
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

}  // namespace drape::app
