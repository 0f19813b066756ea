#pragma once

#include "report/trajectory.hpp"

#include <chrono>
#include <functional>
#include <utility>

namespace drape {

/// Thrown out of a run that takes longer than it may.
struct TooSlow {};

/// How long a run may take, from now on.
class Patience {
 public:
  Patience(std::function<void()> mayStop, double mostSeconds)
      : mayStop_(std::move(mayStop)), mostSeconds_(mostSeconds) {}

  /// To be asked at each step. Throws TooSlow when the time is over, and what `mayStop` throws.
  void ask() const {
    mayStop_();
    if (spent() > mostSeconds_) {
      throw TooSlow();
    }
  }

  /// Since it was made [s].
  [[nodiscard]] double spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  /// For a run that is to ask it. It must outlive the run.
  [[nodiscard]] Watch watch() const {
    Watch watch;
    watch.progress = [this](std::string_view, std::int64_t, std::int64_t) { ask(); };
    return watch;
  }

 private:
  std::function<void()> mayStop_;
  double mostSeconds_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace drape
