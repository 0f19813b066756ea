#include "ui/picked_vertices.hpp"

#include <algorithm>

namespace drape::ui {

bool PickedVertices::toggle(int vertex) {
  const auto found = std::find(vertices_.begin(), vertices_.end(), vertex);
  if (found == vertices_.end() && vertices_.size() == maxCount) {
    return false;
  }
  if (found != vertices_.end()) {
    vertices_.erase(found);
  } else {
    vertices_.push_back(vertex);
  }
  samples_.clear();
  version_ = -1;
  return true;
}

void PickedVertices::clear() {
  vertices_.clear();
  samples_.clear();
}

void PickedVertices::follow(const session::Snapshot& snapshot, fields::SnapshotFields& fields) {
  if (snapshot.scene != scene_) {
    clear();
    scene_ = snapshot.scene;
  }
  if (vertices_.empty() || snapshot.version == version_) {
    return;
  }
  version_ = snapshot.version;
  fields.take(snapshot);
  now_ = {snapshot.time, fields::probe(fields, vertices_)};
  // Later values are those of a motion that the simulation has left, unless the timeline still has it.
  const double newest = snapshot.timeline ? std::max(snapshot.timeline->end, snapshot.time) : snapshot.time;
  samples_.erase(std::ranges::upper_bound(samples_, newest, {}, &Sample::time), samples_.end());
  add(now_);
  const auto old = std::ranges::lower_bound(samples_, samples_.back().time - kept, {}, &Sample::time);
  samples_.erase(samples_.begin(), old);
}

void PickedVertices::add(const Sample& sample) {
  const auto next = std::ranges::lower_bound(samples_, sample.time, {}, &Sample::time);
  if (next != samples_.end() && next->time == sample.time) {
    *next = sample;
  } else if (next != samples_.end()) {
    samples_.insert(next, sample);
  } else {
    const std::size_t count = samples_.size();
    if (count > 1 && samples_[count - 1].time - samples_[count - 2].time < spacing) {
      samples_.pop_back();
    }
    samples_.push_back(sample);
  }
}

std::span<const PickedVertices::Sample> PickedVertices::samples() const {
  if (samples_.empty()) {
    return {};
  }
  const double end = std::min(samples_.back().time, now_.time + 0.5 * window);
  const auto first = std::ranges::lower_bound(samples_, end - window, {}, &Sample::time);
  const auto last = std::ranges::upper_bound(samples_, end, {}, &Sample::time);
  return {first, last};
}

std::string PickedVertices::csv() const {
  std::string table = fields::probeTitles(vertices_);
  for (const Sample& sample : samples()) {
    table += fields::probeLine(sample.time, sample.values);
  }
  return table;
}

}  // namespace drape::ui
