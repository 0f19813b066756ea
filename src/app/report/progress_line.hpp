#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace drape {

/// What is measured, how much is done and how much time is left, on standard error: one line that is written over where
/// that is a terminal, and a line now and then where it is a file or a pipe.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param done of the expected work, `total` [s as expected]; the time left is corrected by how long it really took
  void show(std::string_view section, double done, double total);

  /// Since it was made [s].
  [[nodiscard]] double spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double told_ = 0.0;      // when the last line went to a file, after the beginning [s]
  std::size_t shown_ = 0;  // length of the line on a terminal
  bool terminal_;
};

}  // namespace drape
