#pragma once

#include <string>
#include <string_view>

namespace drape::app {

/// A file name with a placeholder for the frame's number: "{frame}", or "{frame:4}" for at least four digits.
class FramePattern {
 public:
  /// Throws UsageError for another word in braces, or for more than one frame without a placeholder.
  /// @param option that gives the pattern, for messages
  FramePattern(std::string_view pattern, int frames, std::string_view option = "--output");

  [[nodiscard]] std::string name(int frame) const;

 private:
  std::string before_;
  std::string after_;
  int digits_ = 0;
  bool numbered_ = false;
};

}  // namespace drape::app
