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
  samples_.add(now_, newestTime(snapshot));
}

std::string PickedVertices::csv() const {
  std::string table = fields::probeTitles(vertices_);
  for (const Sample& sample : samples()) {
    table += fields::probeLine(sample.time, sample.values);
  }
  return table;
}

}  // namespace drape::ui
