#pragma once

#include "report/trajectory.hpp"

#include <ctime>
#include <functional>
#include <utility>

namespace drape::report::sections {

/// Thrown from a run that exceeds its time limit.
struct TooSlow {};

/// CPU time of the calling thread [s], without the time of other programs.
inline double threadSeconds() {
  constexpr double nano = 1e-9;
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + nano * static_cast<double>(time.tv_nsec);
}

/// The time limit of a run in this thread, starting now, in CPU time of the thread.
class TimeLimit {
 public:
  TimeLimit(std::function<void()> checkStop, double maxSeconds)
      : checkStop_(std::move(checkStop)), maxSeconds_(maxSeconds) {}

  /// Call it at each step. Throws TooSlow after the limit, and forwards exceptions from `checkStop`.
  void check() const {
    checkStop_();
    if (spent() > maxSeconds_) {
      throw TooSlow();
    }
  }

  /// CPU time since construction [s].
  [[nodiscard]] double spent() const { return threadSeconds() - begin_; }

  /// The watch for a run with this limit. It must outlive the run.
  [[nodiscard]] Watch watch() const {
    Watch watch;
    watch.progress = [this](std::string_view, std::int64_t, std::int64_t) { check(); };
    return watch;
  }

 private:
  std::function<void()> checkStop_;
  double maxSeconds_;
  double begin_ = threadSeconds();
};

}  // namespace drape::report::sections
