#pragma once

#include "sim/model/seconds_since.hpp"

#include <chrono>
#include <cstddef>
#include <string_view>

namespace drape::app {

/// The progress of a program: one line on standard error that is overwritten on a terminal.
class ProgressLine {
 public:
  enum class Style {
    Bar,      ///< "label [####    ] 50 %"; only on a terminal
    TimeLeft  ///< "label: 50 %, 2 min 5 s left"; in a file or a pipe, a line now and then
  };

  explicit ProgressLine(Style style = Style::Bar);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Ends the line.
  ~ProgressLine();

  /// Shows the share `done` of `total`, in any unit. A bar that starts again takes a new line. The time left assumes
  /// that the rest goes as fast as everything since construction.
  void show(std::string_view label, double done, double total);

  /// Time since construction [s].
  [[nodiscard]] double spent() const { return sim::secondsSince(begin_); }

 private:
  void overwrite(std::string line, int percent);

  Style style_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double lastLine_ = 0.0;  // time of the last line in a file, since construction [s]
  std::size_t shown_ = 0;  // length of the line on a terminal
  int shownPercent_ = -1;
};

}  // namespace drape::app
