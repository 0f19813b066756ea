#include "ui/measure_history.hpp"

#include <algorithm>

namespace drape::ui {

void MeasureHistory::add(const session::Snapshot& snapshot) {
  if (snapshot.scene != scene_ || (!samples_.empty() && snapshot.time < samples_.back().time)) {
    samples_.clear();
    scene_ = snapshot.scene;
  }
  const std::size_t count = samples_.size();
  const bool crowded = count > 1 && samples_[count - 1].time - samples_[count - 2].time < spacing;
  if (crowded || (count > 0 && snapshot.time == samples_.back().time)) {
    samples_.pop_back();
  }
  samples_.push_back({.time = snapshot.time,
                      .energy = snapshot.energy,
                      .balance = snapshot.balance,
                      .ghostDistance = snapshot.ghost ? std::optional(snapshot.ghost->meanDistance) : std::nullopt,
                      .choice = snapshot.stepReport.choice,
                      .accuracy = snapshot.accuracy});
  const auto recent = std::find_if(samples_.begin(), samples_.end(),
                                   [&](const MeasureSample& sample) { return sample.time >= snapshot.time - window; });
  samples_.erase(samples_.begin(), recent);
}

}  // namespace drape::ui
