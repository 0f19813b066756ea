#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace drape {

/// What is measured, how much is done and how much time is left, in one line on standard error when that is a
/// terminal; silent otherwise.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param done of the expected work, `total` [s as expected]; the time left is corrected by how long it really took
  void show(std::string_view section, double done, double total);

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t shown_ = 0;  // length of the line
  bool terminal_;
};

}  // namespace drape
