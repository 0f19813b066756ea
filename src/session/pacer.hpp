#pragma once

#include <algorithm>

namespace drape::session {

/// Decides how many fixed steps are due. It collects elapsed time and spends it in whole steps. Time beyond a limit is
/// dropped: on a slow machine the simulation becomes slower than real time instead of falling behind without bound.
class Pacer {
 public:
  /// The largest backlog [s].
  static constexpr double longestDebt = 0.25;

  /// Adds elapsed real time [s], scaled by `speed`.
  void collect(double elapsed, double speed) { owed_ = std::min(owed_ + elapsed * speed, longestDebt); }

  /// Whether a step of that length [s] is due; it then counts as taken. A step longer than the limit is due when the
  /// limit is reached, and leaves a negative balance.
  [[nodiscard]] bool takeStep(double timeStep) {
    if (owed_ < std::min(timeStep, longestDebt)) {
      return false;
    }
    owed_ -= timeStep;
    return true;
  }

  /// Real time until the next step is due [s], at speed `speed`.
  [[nodiscard]] double untilNext(double timeStep, double speed) const {
    return std::max(0.0, (std::min(timeStep, longestDebt) - owed_) / speed);
  }

  void forget() { owed_ = 0.0; }

 private:
  double owed_ = 0.0;  // [s]
};

/// Simulated time divided by real time, averaged over about the last half second.
class RealTimeFactor {
 public:
  /// Adds an interval: real time [s] and simulated time [s].
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

}  // namespace drape::session
