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
  if (!samples_.empty() && snapshot.time < samples_.back().time) {
    samples_.clear();
  }
  const std::size_t count = samples_.size();
  const bool crowded = count > 1 && samples_[count - 1].time - samples_[count - 2].time < spacing;
  if (crowded || (count > 0 && snapshot.time == samples_.back().time)) {
    samples_.pop_back();
  }
  fields.take(snapshot);
  samples_.push_back({snapshot.time, fields::probe(fields, vertices_)});
  const auto recent = std::find_if(samples_.begin(), samples_.end(),
                                   [&](const Sample& sample) { return sample.time >= snapshot.time - window; });
  samples_.erase(samples_.begin(), recent);
}

std::string PickedVertices::csv() const {
  std::string table = fields::probeTitles(vertices_);
  for (const Sample& sample : samples_) {
    table += fields::probeLine(sample.time, sample.values);
  }
  return table;
}

}  // namespace drape::ui
