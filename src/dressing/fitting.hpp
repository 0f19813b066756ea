#pragma once

#include "dressing/shrinking_body.hpp"
#include "sim/contact/bodies/world.hpp"
#include "sim/solvers/step_parameters.hpp"
#include "sim/stepping/stepper.hpp"

#include <memory>
#include <vector>

namespace drape::dressing {

/// Moves a cloth out of the way of a body that grows inside it. The cloth moves without gravity, air, inertia and
/// friction: contact pushes it outwards, exact self-collision keeps it from passing through itself, and the springs
/// keep its shape.
class Fitting {
 public:
  /// @param model without pins  @param positions at the start [m]; no triangle passes through the body at the frame
  /// @param frame of the body at the start  @param parameters material and contact; others are ignored except `threads`
  Fitting(const sim::ClothModel& model, std::vector<Vec3> positions, const ShrinkingBody& body, std::size_t frame,
          const sim::StepParameters& parameters);

  /// Moves body and cloth by one step of `stepSeconds`.
  void step();

  /// Whether the body has its full size.
  [[nodiscard]] bool isGrown() const { return state_.time >= growthTime_; }
  /// The time that the growth takes [s].
  [[nodiscard]] double growthTime() const { return growthTime_; }
  /// The sum of all steps [s].
  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] const std::vector<Vec3>& positions() const { return state_.positions; }

  /// Length of a step [s].
  static constexpr double stepSeconds = 1.0 / 150.0;
  /// No vertex of the body moves faster [m/s]: 2 mm a step, half of the usual distance between cloth and body.
  static constexpr double growthSpeed = 0.3;

 private:
  std::shared_ptr<const sim::ClothModel> model_;
  sim::StepParameters parameters_;
  double growthTime_ = 0.0;
  sim::contact::BodyWorld world_;
  sim::ClothState state_;
  sim::Stepper stepper_;
};

}  // namespace drape::dressing
