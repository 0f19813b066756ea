#pragma once

#include "sim/contact/bodies/motion.hpp"
#include "sim/forces/step_inputs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace drape::scene {

/// Pins that move together along keyframes, without a body. A keyframe's position is the displacement from the start of
/// the scene, and its rotation is about the centre of the pins at the start.
struct PinPath {
  std::vector<int> vertices;
  Vec3 centre = Vec3::Zero();  ///< of the pins at the start [m]
  sim::contact::BodyMotion motion;

  bool operator==(const PinPath&) const = default;
};

/// The path of vertices at these positions [m], one a vertex of the cloth.
[[nodiscard]] PinPath pathOf(std::vector<int> vertices, sim::contact::BodyMotion motion,
                             const std::vector<Vec3>& positions);

/// The pose at a time [s]: a pin with the place p [m] at the pose A has the place B.toWorld(A.toLocal(p)) at B.
[[nodiscard]] sim::contact::Pose poseAt(const PinPath& path, double time);

/// The displacements of pins in a step from `time` [s]. Pins at rest are left out.
[[nodiscard]] std::vector<sim::MovedPin> movedPins(const std::vector<PinPath>& paths,
                                                   const std::vector<Vec3>& positions, double time, double timeStep);

/// What is wrong with a motion of pins; empty: nothing. Keyframes must have finite values and ascending times, a loop
/// at least two of them, and there is no spin.
[[nodiscard]] std::optional<std::string> faultOf(const sim::contact::BodyMotion& motion);

}  // namespace drape::scene
