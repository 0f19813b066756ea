#include "scene/pin_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::scene {
namespace {

bool isFinite(const sim::contact::Keyframe& key) {
  return std::isfinite(key.time) && key.position.allFinite() && key.rotation.allFinite();
}

}  // namespace

PinPath pathOf(std::vector<int> vertices, sim::contact::BodyMotion motion, const std::vector<Vec3>& positions) {
  PinPath path{std::move(vertices), Vec3::Zero(), std::move(motion)};
  for (const int vertex : path.vertices) {
    path.centre += positions[vertex];
  }
  path.centre /= static_cast<double>(std::max<std::size_t>(1, path.vertices.size()));
  return path;
}

sim::contact::Pose poseAt(const PinPath& path, double time) {
  sim::contact::Pose pose = sim::contact::poseAt(path.motion, time);
  pose.position += path.centre - pose.rotation * path.centre;
  return pose;
}

std::vector<sim::MovedPin> movedPins(const std::vector<PinPath>& paths, const std::vector<Vec3>& positions, double time,
                                     double timeStep) {
  std::vector<sim::MovedPin> moved;
  for (const PinPath& path : paths) {
    if (!path.motion.moves()) {
      continue;
    }
    const sim::contact::Pose start = poseAt(path, time);
    const sim::contact::Pose end = poseAt(path, time + timeStep);
    if (start.position == end.position && start.rotation.coeffs() == end.rotation.coeffs()) {
      continue;
    }
    for (const int vertex : path.vertices) {
      const Vec3& place = positions[vertex];
      moved.push_back({vertex, end.toWorld(start.toLocal(place)) - place});
    }
  }
  return moved;
}

std::optional<std::string> faultOf(const sim::contact::BodyMotion& motion) {
  const std::vector<sim::contact::Keyframe>& keys = motion.keyframes;
  if (keys.empty() || !std::ranges::all_of(keys, isFinite)) {
    return "moving pins need keyframes with finite values";
  }
  const auto ascends = [](const sim::contact::Keyframe& first, const sim::contact::Keyframe& second) {
    return second.time > first.time;
  };
  if (std::ranges::adjacent_find(keys, [&](const auto& a, const auto& b) { return !ascends(a, b); }) != keys.end()) {
    return "the times of the keyframes must ascend";
  }
  if (motion.loop && keys.size() < 2) {
    return "a loop needs at least two keyframes";
  }
  if (!motion.spin.isZero(0.0)) {
    return "pins without a body have no spin";
  }
  return std::nullopt;
}

}  // namespace drape::scene
