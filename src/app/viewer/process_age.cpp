#include "app/viewer/process_age.hpp"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace drape::app {

double processAge() {
  // proc(5): the start time is field 22, in clock ticks since boot. Field 2, the name, may contain spaces but ends with
  // the last bracket.
  constexpr int fieldsBetween = 19;  // from the bracket to the start time
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t bracket = text.rfind(')');
  if (bracket == std::string::npos) {
    return 0.0;
  }
  std::istringstream fields(text.substr(bracket + 1));
  std::string skipped;
  for (int i = 0; i < fieldsBetween; ++i) {
    fields >> skipped;
  }
  double start = 0.0;
  timespec now{};
  if (!(fields >> start) || clock_gettime(CLOCK_BOOTTIME, &now) != 0) {
    return 0.0;
  }
  const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  return std::max(0.0, seconds - start / static_cast<double>(sysconf(_SC_CLK_TCK)));
}

}  // namespace drape::app
