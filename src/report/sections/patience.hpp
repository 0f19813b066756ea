#pragma once

#include "report/trajectory.hpp"

#include <ctime>
#include <functional>
#include <utility>

namespace drape {

/// Thrown out of a run that takes longer than it may.
struct TooSlow {};

/// The time that the calling thread has had a processor for [s]: other programs' turns do not count.
inline double threadSeconds() {
  constexpr double nano = 1e-9;
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + nano * static_cast<double>(time.tv_nsec);
}

/// How long a run in this thread may take, from now on, by the thread's own clock.
class Patience {
 public:
  Patience(std::function<void()> checkStop, double mostSeconds)
      : checkStop_(std::move(checkStop)), mostSeconds_(mostSeconds) {}

  /// To be asked at each step. Throws TooSlow when the time is over, and what `checkStop` throws.
  void ask() const {
    checkStop_();
    if (spent() > mostSeconds_) {
      throw TooSlow();
    }
  }

  /// Since it was made [s].
  [[nodiscard]] double spent() const { return threadSeconds() - begin_; }

  /// For a run that is to ask it. It must outlive the run.
  [[nodiscard]] Watch watch() const {
    Watch watch;
    watch.progress = [this](std::string_view, std::int64_t, std::int64_t) { ask(); };
    return watch;
  }

 private:
  std::function<void()> checkStop_;
  double mostSeconds_;
  double begin_ = threadSeconds();
};

}  // namespace drape
