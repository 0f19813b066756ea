#include "ui/pin_keys.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace drape::ui {
namespace {

const std::vector<Vec3>& startOf(const session::Snapshot& snapshot) {
  return snapshot.placedStart ? *snapshot.placedStart : snapshot.scene->start.positions;
}

/// The mean displacement of pins from the start [m].
Vec3 displacementOf(const session::Snapshot& snapshot, std::span<const int> pins) {
  Vec3 sum = Vec3::Zero();
  for (const int pin : pins) {
    sum += snapshot.positions[pin] - startOf(snapshot)[pin];
  }
  return sum / static_cast<double>(pins.size());
}

void insert(const sim::contact::Keyframe& key, std::vector<sim::contact::Keyframe>& keys) {
  constexpr double sameTime = 1e-9;  // [s]
  std::erase_if(keys, [&](const auto& each) { return std::abs(each.time - key.time) < sameTime; });
  keys.insert(std::ranges::upper_bound(keys, key.time, {}, &sim::contact::Keyframe::time), key);
}

/// The paths without these pins.
std::vector<scene::PinPath> pathsWithout(const session::Snapshot& snapshot, std::span<const int> pins) {
  std::vector<scene::PinPath> paths = *snapshot.pinPaths;
  for (scene::PinPath& path : paths) {
    std::erase_if(path.vertices, [&](int vertex) { return std::ranges::find(pins, vertex) != pins.end(); });
  }
  std::erase_if(paths, [](const scene::PinPath& path) { return path.vertices.empty(); });
  return paths;
}

}  // namespace

std::vector<int> pinnedOf(const session::Snapshot& snapshot, std::span<const int> vertices) {
  std::vector<int> pins;
  std::ranges::copy_if(vertices, std::back_inserter(pins), [&](int vertex) { return snapshot.model->pinned[vertex]; });
  return pins;
}

const sim::contact::BodyMotion* commonMotion(const session::Snapshot& snapshot, std::span<const int> pins) {
  const auto hasAll = [&](const scene::PinPath& path) {
    return std::ranges::all_of(pins,
                               [&](int pin) { return std::ranges::find(path.vertices, pin) != path.vertices.end(); });
  };
  const auto found = std::ranges::find_if(*snapshot.pinPaths, hasAll);
  return pins.empty() || found == snapshot.pinPaths->end() ? nullptr : &found->motion;
}

session::SetPinPathsCommand withMotion(const session::Snapshot& snapshot, std::span<const int> pins,
                                       sim::contact::BodyMotion motion) {
  session::SetPinPathsCommand command{pathsWithout(snapshot, pins)};
  if (!motion.keyframes.empty()) {
    command.paths.push_back(scene::pathOf({pins.begin(), pins.end()}, std::move(motion), startOf(snapshot)));
  }
  return command;
}

session::SetPinPathsCommand withKeyframeHere(const session::Snapshot& snapshot, std::span<const int> pins) {
  const sim::contact::BodyMotion* present = commonMotion(snapshot, pins);
  sim::contact::BodyMotion motion = present == nullptr ? sim::contact::BodyMotion{} : *present;
  if (motion.keyframes.empty()) {
    motion.keyframes.emplace_back();
  }
  const Vec3 atStart = sim::contact::keyframeAt(motion, 0.0).position;
  const Vec3 turn = sim::contact::keyframeAt(motion, snapshot.time).rotation;
  insert({snapshot.time, atStart + displacementOf(snapshot, pins), turn}, motion.keyframes);
  session::SetPinPathsCommand command = withMotion(snapshot, pins, std::move(motion));
  command.moves = false;
  return command;
}

}  // namespace drape::ui
