#include "session/timeline.hpp"

#include "sim/checkpoint/state_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::session {
namespace {

constexpr double megabyte = 1e6;            // [bytes]
constexpr std::int64_t measuredOneIn = 64;  // states whose size is measured
constexpr double rounding = 1e-9;           // of a sum of steps [s]

std::size_t sizeOf(const RecordedState& state) {
  return sim::bytesOf(state.state).size() + (state.ghost ? sim::bytesOf(*state.ghost).size() : 0);
}

bool comesBefore(std::int64_t step, const RecordedState& state) {
  return step < state.step;
}

}  // namespace

void Timeline::limit(double megabytes) {
  maxBytes_ = static_cast<std::size_t>(megabytes * megabyte);
  if (!isOn()) {
    clear();
  }
}

void Timeline::clear() {
  states_.clear();
  recorded_ = 0;
  thinning_ = 1;
}

std::int64_t Timeline::spacing(double timeStep) const {
  return thinning_ * std::max<std::int64_t>(1, std::llround(frame / timeStep));
}

bool Timeline::isDue(std::int64_t step, double timeStep) const {
  return isOn() && step % spacing(timeStep) == 0;
}

void Timeline::record(RecordedState state) {
  states_.erase(
      std::find_if(states_.begin(), states_.end(), [&](const RecordedState& each) { return each.step >= state.step; }),
      states_.end());
  if (recorded_++ % measuredOneIn == 0) {
    bytesOfOne_ = sizeOf(state);
  }
  states_.push_back(std::move(state));
  keepWithinLimits();
}

void Timeline::keepWithinLimits() {
  const double oldest = states_.back().state.time - longest - rounding;
  states_.erase(states_.begin(), std::find_if(states_.begin(), states_.end(),
                                              [&](const RecordedState& each) { return each.state.time >= oldest; }));
  if (states_.size() > 2 && states_.size() * bytesOfOne_ > maxBytes_) {
    // Counted from the newest one, which stays.
    std::size_t behind = states_.size();
    std::erase_if(states_, [&](const RecordedState&) { return --behind % 2 == 1; });
    thinning_ *= 2;
  }
}

const RecordedState* Timeline::at(std::int64_t step) const {
  if (states_.empty()) {
    return nullptr;
  }
  const auto after = std::upper_bound(states_.begin(), states_.end(), step, comesBefore);
  return after == states_.begin() ? &states_.front() : &*std::prev(after);
}

const RecordedState& Timeline::nearest(double time) const {
  return *std::min_element(states_.begin(), states_.end(), [&](const RecordedState& a, const RecordedState& b) {
    return std::abs(a.state.time - time) < std::abs(b.state.time - time);
  });
}

std::optional<TimelineStatus> Timeline::status(double timeStep) const {
  if (states_.empty()) {
    return std::nullopt;
  }
  return TimelineStatus{.begin = states_.front().state.time,
                        .end = states_.back().state.time,
                        .states = states_.size(),
                        .megabytes = static_cast<double>(states_.size() * bytesOfOne_) / megabyte,
                        .spacing = spacing(timeStep)};
}

}  // namespace drape::session
