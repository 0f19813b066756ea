#include "app/progress_bar.hpp"

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

namespace drape {

ProgressBar::ProgressBar(std::string label, std::int64_t total)
    : label_(std::move(label)), total_(std::max<std::int64_t>(total, 1)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_ && shownPercent_ >= 0) {
    std::cerr << '\n';
  }
}

void ProgressBar::show(std::int64_t done) {
  constexpr int width = 40;
  const int percent = static_cast<int>(100 * done / total_);
  if (!terminal_ || percent == shownPercent_) {
    return;
  }
  shownPercent_ = percent;
  const auto filled = static_cast<std::size_t>(std::clamp(percent * width / 100, 0, width));
  std::cerr << '\r' << label_ << " [" << std::string(filled, '#') << std::string(width - filled, ' ') << "] " << percent
            << " %" << std::flush;
}

}  // namespace drape
