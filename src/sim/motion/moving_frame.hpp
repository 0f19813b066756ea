#pragma once

#include "sim/forces/air_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::sim {

/// A frame of reference that moves with the mean velocity of the pins during a step. Solvers assume that pins are at
/// rest: with moving pins, the damping of their springs would slow the cloth down. In the moving frame the pins are at
/// rest, and nothing else changes (Galilean invariance), for any solver. Pins that move differently, as on a rotating
/// body, keep their velocities relative to the mean.
class MovingFrame {
 public:
  /// @param velocity of the frame [m/s]; zero: nothing changes, bit for bit
  explicit MovingFrame(const Vec3& velocity) : velocity_(velocity), moves_(!velocity.isZero(0.0)) {}

  /// Air and inputs relative to the frame.
  [[nodiscard]] AirParameters toFrame(AirParameters air) const;
  [[nodiscard]] StepInputs toFrame(StepInputs inputs, double timeStep) const;

  /// Transforms the state to the frame at the start of a step of that length [s], and back at its end. The pins must be
  /// at their positions at the end of the step.
  void enter(const ClothModel& model, double timeStep, ClothState& state);
  void leave(const ClothModel& model, double timeStep, ClothState& state) const;

 private:
  Vec3 velocity_;
  bool moves_;
  std::vector<Vec3> startPositions_;  // at `enter` [m]
};

}  // namespace drape::sim
