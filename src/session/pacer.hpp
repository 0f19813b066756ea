#pragma once

#include <algorithm>

namespace drape {

/// Decides how many fixed steps are due. Time that passes is collected and paid out in whole steps; what could not be
/// paid is forgotten beyond a limit, so that a machine that cannot keep up slows the clock down instead of falling
/// behind further and further.
class Pacer {
 public:
  /// The longest stretch of time that is ever made up for [s].
  static constexpr double longestDebt = 0.25;

  /// Collects elapsed time of the clock [s], scaled by `speed`.
  void collect(double elapsed, double speed) { owed_ = std::min(owed_ + elapsed * speed, longestDebt); }

  /// True when a step of that length [s] is due; it is then counted as taken. A step that is longer than the limit is
  /// due as soon as the limit is reached, and leaves a debt of its own.
  [[nodiscard]] bool takeStep(double timeStep) {
    if (owed_ < std::min(timeStep, longestDebt)) {
      return false;
    }
    owed_ -= timeStep;
    return true;
  }

  /// Time until the next step is due [s], when the clock runs at `speed`.
  [[nodiscard]] double untilNext(double timeStep, double speed) const {
    return std::max(0.0, (std::min(timeStep, longestDebt) - owed_) / speed);
  }

  void forget() { owed_ = 0.0; }

 private:
  double owed_ = 0.0;  // [s]
};

/// Simulated time over time of the clock, averaged over about the last half second.
class RealTimeFactor {
 public:
  /// Adds what happened in an interval of the clock [s] [s].
  void add(double elapsed, double simulated) {
    elapsed_ += elapsed;
    simulated_ += simulated;
    if (elapsed_ >= window) {
      value_ = simulated_ / elapsed_;
      elapsed_ = 0.0;
      simulated_ = 0.0;
    }
  }
  void reset() { *this = RealTimeFactor(); }
  [[nodiscard]] double value() const { return value_; }

 private:
  static constexpr double window = 0.5;  // [s]
  double elapsed_ = 0.0;
  double simulated_ = 0.0;
  double value_ = 0.0;
};

}  // namespace drape
