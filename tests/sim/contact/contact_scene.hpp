#pragma once

#include "intersection/intersections.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/stepping/stepper.hpp"
#include "test_meshes.hpp"

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace drape::sim::testing {

using namespace contact;

/// The number of intersecting pairs of a cloth's and a body's drawn triangles, in exact arithmetic.
inline int intersectingPairs(const ClothModel& model, const std::vector<Vec3>& cloth, const BodySurface& surface,
                             const Pose& pose) {
  std::vector<Vec3> body;
  for (const Vec3& position : surface.positions) {
    body.push_back(pose.toWorld(position));
  }
  return static_cast<int>(
      drape::intersection::intersectingPairs({cloth, model.triangles}, {body, surface.triangles}).size());
}

/// A cloth with bodies and a solver.
class ContactScene {
 public:
  ContactScene(std::shared_ptr<const ClothModel> model, std::vector<Body> bodies, const std::string& solver = "xpbd")
      : model_(std::move(model)),
        world_(std::make_shared<const std::vector<Body>>(std::move(bodies)), 0.0),
        stepper_(solver) {
    state = stateAtRest(model_->restPositions);
  }

  StepReport step() {
    world_.advance(state.time, parameters.timeStep);
    StepInputs inputs;
    inputs.bodies = &world_.steps();
    inputs.movedPins = movedPins.empty() ? nullptr : &movedPins;
    return stepper_.step(*model_, parameters, inputs, state);
  }

  /// Simulates that time [s] and calls `each(report)` after every step.
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

  /// The number of intersecting pairs of the cloth's triangles, in exact arithmetic.
  [[nodiscard]] std::size_t pairsWithItself() const {
    return drape::intersection::intersectingPairs({state.positions, model_->triangles}).size();
  }

  [[nodiscard]] const ClothModel& model() const { return *model_; }
  [[nodiscard]] BodyWorld& world() { return world_; }
  [[nodiscard]] const Stepper& stepper() const { return stepper_; }

  StepParameters parameters;
  ClothState state;
  std::vector<MovedPin> movedPins;

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

/// A body at rest.
inline Body bodyAt(BodyShape shape, const Vec3& position, const Vec3& rotation = Vec3::Zero()) {
  Body body;
  body.shape = std::move(shape);
  body.motion.keyframes = {{0.0, position, rotation}};
  return body;
}

/// A sheet without pins, translated and rotated.
inline std::shared_ptr<const ClothModel> freeSheet(int n, double size, const Vec3& middle,
                                                   const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
  ClothMesh mesh = sheet(n);
  for (Vec3& position : mesh.positions) {
    position = middle + turn * (size * (position - Vec3(0.5, 0.0, 0.5)));
  }
  return buildClothModel(mesh, 0.15 * size * size, MassLumping::Area, {});
}

/// Adds a sheet, and returns the index of its first vertex.
inline int addSheet(int n, double size, const Vec3& middle, const Eigen::Quaterniond& turn, ClothMesh& mesh) {
  const ClothMesh own = sheet(n);
  const auto first = static_cast<int>(mesh.positions.size());
  for (const Vec3& position : own.positions) {
    mesh.positions.push_back(middle + turn * (size * (position - Vec3(0.5, 0.0, 0.5))));
  }
  for (const Triangle& triangle : own.triangles) {
    mesh.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  return first;
}

}  // namespace drape::sim::testing
