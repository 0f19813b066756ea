#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace drape {

/// The current measurement, the progress and the remaining time, on standard error: one line that is overwritten on a
/// terminal, or a line now and then in a file or a pipe.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// @param done part of `total`, the expected work [s]; the remaining time is corrected by the time spent so far
  void show(std::string_view section, double done, double total);

  /// Time since construction [s].
  [[nodiscard]] double spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double told_ = 0.0;      // time of the last line in a file, since construction [s]
  std::size_t shown_ = 0;  // length of the line on a terminal
  bool terminal_;
};

}  // namespace drape
