#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

#include <vector>

namespace drape {

/// A frame that moves evenly during a step, with the mean velocity of what is pinned. To a solver pins are at rest:
/// where they move, damping between them and their neighbours would brake the cloth. Seen from a frame that goes along
/// they rest indeed, and everything else is as it was (Galilei), for any solver. Pins that move differently from each
/// other, as on a body that turns, keep what they have against the mean.
class MovingFrame {
 public:
  /// @param velocity of the frame [m/s]; zero: nothing is changed, to the last bit
  explicit MovingFrame(const Vec3& velocity) : velocity_(velocity), moves_(!velocity.isZero(0.0)) {}

  /// What acts on the cloth, as seen from the frame.
  [[nodiscard]] StepParameters seen(StepParameters parameters) const;
  [[nodiscard]] StepInputs seen(StepInputs inputs, double timeStep) const;

  /// Goes over to the frame, at the start of a step of that length [s], and back at its end. What is pinned is where it
  /// is at the end of the step, before and after.
  void enter(const ClothModel& model, double timeStep, ClothState& state);
  void leave(const ClothModel& model, double timeStep, ClothState& state) const;

 private:
  Vec3 velocity_;
  bool moves_;
  std::vector<Vec3> entered_;  // where the vertices were when the frame was entered [m]
};

}  // namespace drape
