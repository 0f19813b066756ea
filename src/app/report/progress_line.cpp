#include "app/report/progress_line.hpp"
#include "text/number_text.hpp"

#include <unistd.h>
#include <algorithm>
#include <iostream>
#include <string>

namespace drape {
namespace {

constexpr double betweenLines = 15.0;  // in a file [s]

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_ > 0) {
    std::cerr << '\n';
  }
}

void ProgressLine::show(std::string_view section, double done, double total) {
  if (!(total > 0.0)) {
    return;
  }
  if (!terminal_ && spent() - told_ < betweenLines) {
    return;
  }
  const double pace = done > 0.0 ? spent() / done : 1.0;
  std::string line = std::string(section) + ": " + std::to_string(static_cast<int>(100.0 * done / total)) + " %, " +
                     formatMinutes(pace * (total - done)) + " left";
  if (!terminal_) {
    told_ = spent();
    std::cerr << line << std::endl;
    return;
  }
  const std::size_t length = line.size();
  line.resize(std::max(length, shown_), ' ');
  shown_ = length;
  std::cerr << '\r' << line << std::flush;
}

}  // namespace drape
