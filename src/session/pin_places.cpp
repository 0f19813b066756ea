#include "session/pin_places.hpp"

#include <map>

namespace drape::session {
namespace {

/// The pose of each vertex with a path, relative to the start of the scene.
std::map<int, sim::contact::Pose> posesAt(const std::vector<scene::PinPath>& paths, double time) {
  std::map<int, sim::contact::Pose> poses;
  for (const scene::PinPath& path : paths) {
    const sim::contact::Pose first = scene::poseAt(path, 0.0);
    const sim::contact::Pose now = scene::poseAt(path, time);
    const Eigen::Quaterniond turn = now.rotation * first.rotation.conjugate();
    const sim::contact::Pose sinceStart{turn, now.position - turn * first.position};
    for (const int vertex : path.vertices) {
      poses[vertex] = sinceStart;
    }
  }
  return poses;
}

}  // namespace

PinMoves movesBetween(const std::vector<scene::PinPath>& earlier, const std::vector<scene::PinPath>& later,
                      const sim::ClothModel& model, const sim::ClothState& state) {
  std::map<int, sim::contact::Pose> before = posesAt(earlier, state.time);
  std::map<int, sim::contact::Pose> after = posesAt(later, state.time);
  PinMoves moves;
  for (const auto* poses : {&before, &after}) {
    for (const auto& [vertex, pose] : *poses) {
      const bool isSecond = poses == &after && before.contains(vertex);
      if (model.pinned[vertex] && !isSecond) {
        moves.vertices.push_back(vertex);
      }
    }
  }
  for (const int vertex : moves.vertices) {
    moves.places.push_back(after[vertex].toWorld(before[vertex].toLocal(state.positions[vertex])));
  }
  return moves;
}

void placeVertices(const std::vector<int>& vertices, const std::vector<Vec3>& places, sim::ClothState& state) {
  state.hasNoSelfIntersection = false;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    state.positions[vertices[i]] = places[i];
    state.velocities[vertices[i]].setZero();
  }
}

}  // namespace drape::session
