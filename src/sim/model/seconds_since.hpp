#pragma once

#include <chrono>

namespace drape::sim {

/// Wall-clock time since `begin` [s].
[[nodiscard]] inline double secondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace drape::sim
