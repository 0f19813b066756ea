#pragma once

#include "session/snapshot.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace drape::ui {

/// The time up to which the simulation still has its motion: that of the newest state of the timeline [s].
[[nodiscard]] inline double newestTime(const session::Snapshot& snapshot) {
  return snapshot.timeline ? std::max(snapshot.timeline->end, snapshot.time) : snapshot.time;
}

/// Samples of a motion in order of simulated time, thinned out. When the timeline goes back, later samples stay until
/// the simulation goes on from there.
/// @tparam Sample has a member `time` [s]
template <typename Sample>
class TimeSamples {
 public:
  /// @param kept length of what is kept [s]
  /// @param spacing minimum distance between samples, except for the newest [s]
  TimeSamples(double kept, double spacing) : kept_(kept), spacing_(spacing) {}

  void clear() { samples_.clear(); }

  /// Adds the sample of the present time. One of the same time replaces the old one.
  /// @param newest as of newestTime() [s]. Later samples are removed: they are those of a motion that the simulation
  /// has left.
  void add(Sample sample, double newest) {
    present_ = sample.time;
    samples_.erase(std::ranges::upper_bound(samples_, newest, {}, &Sample::time), samples_.end());
    insert(std::move(sample));
    const auto old = std::ranges::lower_bound(samples_, samples_.back().time - kept_, {}, &Sample::time);
    samples_.erase(samples_.begin(), old);
  }

  /// The time of the last added sample [s].
  [[nodiscard]] double present() const { return present_; }

  /// The newest samples, or those around the present time after a return to a time long ago.
  /// @param window how much time they cover at most [s]
  [[nodiscard]] std::span<const Sample> around(double window) const {
    if (samples_.empty()) {
      return {};
    }
    const double end = std::min(samples_.back().time, present_ + 0.5 * window);
    const auto first = std::ranges::lower_bound(samples_, end - window, {}, &Sample::time);
    const auto last = std::ranges::upper_bound(samples_, end, {}, &Sample::time);
    return {first, last};
  }

 private:
  void insert(Sample sample) {
    const auto next = std::ranges::lower_bound(samples_, sample.time, {}, &Sample::time);
    if (next != samples_.end() && next->time == sample.time) {
      *next = std::move(sample);
    } else if (next != samples_.end()) {
      samples_.insert(next, std::move(sample));
    } else {
      const std::size_t count = samples_.size();
      if (count > 1 && samples_[count - 1].time - samples_[count - 2].time < spacing_) {
        samples_.pop_back();
      }
      samples_.push_back(std::move(sample));
    }
  }

  std::vector<Sample> samples_;
  double kept_;
  double spacing_;
  double present_ = 0.0;
};

}  // namespace drape::ui
