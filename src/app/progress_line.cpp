#include "app/progress_line.hpp"

#include "text/number_text.hpp"

#include <fmt/core.h>
#include <unistd.h>
#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

namespace drape::app {
namespace {

constexpr double betweenLines = 15.0;  // in a file [s]

std::string barText(std::string_view label, int percent) {
  constexpr int width = 40;
  const auto filled = static_cast<std::size_t>(std::clamp(percent * width / 100, 0, width));
  return fmt::format("{} [{:<{}}] {} %", label, std::string(filled, '#'), width, percent);
}

}  // namespace

ProgressLine::ProgressLine(Style style) : style_(style), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_ > 0) {
    std::cerr << '\n';
  }
}

void ProgressLine::show(std::string_view label, double done, double total) {
  const bool bar = style_ == Style::Bar;
  if (!(total > 0.0) || (!terminal_ && (bar || spent() - lastLine_ < betweenLines))) {
    return;
  }
  const int percent = static_cast<int>(100.0 * done / total);
  if (bar) {
    if (percent != shownPercent_) {
      overwrite(barText(label, percent), percent);
    }
    return;
  }
  const double pace = done > 0.0 ? spent() / done : 1.0;
  std::string line = fmt::format("{}: {} %, {} left", label, percent, text::formatMinutes(pace * (total - done)));
  if (terminal_) {
    overwrite(std::move(line), percent);
  } else {
    lastLine_ = spent();
    std::cerr << line << std::endl;
  }
}

void ProgressLine::overwrite(std::string line, int percent) {
  if (style_ == Style::Bar && percent < shownPercent_) {
    std::cerr << '\n';
    shown_ = 0;
  }
  shownPercent_ = percent;
  const std::size_t length = line.size();
  line.resize(std::max(length, shown_), ' ');
  shown_ = length;
  std::cerr << '\r' << line << std::flush;
}

}  // namespace drape::app
