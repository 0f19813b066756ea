#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/body_world.hpp"
#include "sim/stepper.hpp"

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace drape::testing {

using MeshCorners = std::array<Vec3, 3>;

/// Whether the segment from a to b crosses the triangle, by the signs of five volumes. It shares nothing with the
/// contact code; touching counts as not crossing.
inline bool crosses(const Vec3& a, const Vec3& b, const MeshCorners& t) {
  const auto volume = [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    return (q - p).cross(r - p).dot(s - p);
  };
  if (volume(t[0], t[1], t[2], a) * volume(t[0], t[1], t[2], b) >= 0.0) {
    return false;
  }
  const double u = volume(a, b, t[0], t[1]);
  const double v = volume(a, b, t[1], t[2]);
  const double w = volume(a, b, t[2], t[0]);
  return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

inline bool intersect(const MeshCorners& s, const MeshCorners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (crosses(s[k], s[(k + 1) % 3], t) || crosses(t[k], t[(k + 1) % 3], s)) {
      return true;
    }
  }
  return false;
}

inline MeshCorners cornersAt(const std::vector<Vec3>& positions, const Triangle& t) {
  return {positions[static_cast<std::size_t>(t[0])], positions[static_cast<std::size_t>(t[1])],
          positions[static_cast<std::size_t>(t[2])]};
}

/// How many pairs of a cloth's and a body's drawn triangles intersect.
inline int intersectingPairs(const ClothModel& model, const std::vector<Vec3>& cloth, const BodySurface& surface,
                             const Pose& pose) {
  std::vector<Vec3> body;
  for (const Vec3& position : surface.positions) {
    body.push_back(pose.toWorld(position));
  }
  int pairs = 0;
  for (const Triangle& s : model.triangles) {
    const MeshCorners mine = cornersAt(cloth, s);
    Eigen::AlignedBox3d box;
    for (const Vec3& corner : mine) {
      box.extend(corner);
    }
    for (const Triangle& t : surface.triangles) {
      const MeshCorners theirs = cornersAt(body, t);
      Eigen::AlignedBox3d other;
      for (const Vec3& corner : theirs) {
        other.extend(corner);
      }
      pairs += box.intersects(other) && intersect(mine, theirs) ? 1 : 0;
    }
  }
  return pairs;
}

/// A cloth among bodies, moved by any solver.
class Meeting {
 public:
  Meeting(std::shared_ptr<const ClothModel> model, std::vector<Body> bodies, const std::string& solver = "xpbd")
      : model_(std::move(model)),
        world_(std::make_shared<const std::vector<Body>>(std::move(bodies)), 0.0),
        stepper_(solver) {
    state = stateAtRest(model_->restPositions);
  }

  StepReport step() {
    world_.advance(state.time, parameters.timeStep);
    StepInputs inputs;
    inputs.bodies = &world_.steps();
    return stepper_.step(*model_, parameters, inputs, state);
  }

  /// Steps for that time [s] and calls `each(report)` after every step.
  void run(double seconds, const std::function<void(const StepReport&)>& each = {}) {
    const auto steps = static_cast<int>(std::lround(seconds / parameters.timeStep));
    for (int i = 0; i < steps; ++i) {
      const StepReport report = step();
      if (each) {
        each(report);
      }
    }
  }

  [[nodiscard]] int pairs(std::size_t body) const {
    return intersectingPairs(*model_, state.positions, {surfaceAt(body), surfaceOf(bodyShape(body)).triangles},
                             world_.pose(body));
  }

  [[nodiscard]] const ClothModel& model() const { return *model_; }
  [[nodiscard]] BodyWorld& world() { return world_; }
  [[nodiscard]] const Stepper& stepper() const { return stepper_; }

  StepParameters parameters;
  ClothState state;

 private:
  [[nodiscard]] const BodyShape& bodyShape(std::size_t body) const { return world_.bodies()[body].shape; }
  [[nodiscard]] std::vector<Vec3> surfaceAt(std::size_t body) const {
    const auto moving = world_.vertices(body);
    return moving.empty() ? surfaceOf(bodyShape(body)).positions : std::vector<Vec3>(moving.begin(), moving.end());
  }

  std::shared_ptr<const ClothModel> model_;
  BodyWorld world_;
  Stepper stepper_;
};

/// A body that stands still there.
inline Body bodyAt(BodyShape shape, const Vec3& position, const Vec3& rotation = Vec3::Zero()) {
  Body body;
  body.shape = std::move(shape);
  body.motion.keyframes = {{0.0, position, rotation}};
  return body;
}

}  // namespace drape::testing
