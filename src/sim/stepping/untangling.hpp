#pragma once

#include "intersection/intersections.hpp"
#include "sim/solvers/step_parameters.hpp"
#include "sim/stepping/stepper.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim {

/// Removes the intersections of a cloth with itself, before it is simulated. The cloth moves without gravity, air and
/// inertia: exact self-collision moves crossing parts apart, and the springs keep its shape. Bodies are ignored.
class Untangling {
 public:
  /// @param model whose pins stay where they are  @param positions at the start [m]
  /// @param parameters material and contact; all others are ignored except `threads`
  Untangling(std::shared_ptr<const ClothModel> model, std::vector<Vec3> positions, const StepParameters& parameters);

  /// Moves layers in one plane apart (openFlatLayers). Call it before the first step.
  /// @param pairs two intersecting triangles each
  void openFlatLayers(std::span<const intersection::TrianglePair> pairs);

  /// Moves the cloth by one step of `stepSeconds`.
  void step();

  /// Whether nothing intersected at the start and at the end of the last step.
  [[nodiscard]] bool isDone() const { return state_.hasNoSelfIntersection; }
  [[nodiscard]] const std::vector<Vec3>& positions() const { return state_.positions; }
  /// The sum of all steps [s].
  [[nodiscard]] double time() const { return state_.time; }

  /// Length of a step [s].
  static constexpr double stepSeconds = 1.0 / 150.0;

 private:
  std::shared_ptr<const ClothModel> model_;
  StepParameters parameters_;
  ClothState state_;
  Stepper stepper_;
};

}  // namespace drape::sim
