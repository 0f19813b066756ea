#include "sim/motion/moving_frame.hpp"

namespace drape::sim {
namespace {

/// Adds `move` to the positions and `velocity` to the velocities of free vertices.
void shift(const ClothModel& model, const Vec3& move, const Vec3& velocity, std::vector<Vec3>& positions,
           std::vector<Vec3>& velocities) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!model.pinned[v]) {
      positions[v] += move;
      velocities[v] += velocity;
    }
  }
}

}  // namespace

AirParameters MovingFrame::toFrame(AirParameters air) const {
  air.wind -= velocity_;
  return air;
}

StepInputs MovingFrame::toFrame(StepInputs inputs, double timeStep) const {
  if (inputs.attachment) {
    inputs.attachment->target -= timeStep * velocity_;
  }
  inputs.frameVelocity += velocity_;
  return inputs;
}

void MovingFrame::enter(const ClothModel& model, double timeStep, ClothState& state) {
  if (!moves_) {
    return;
  }
  startPositions_ = state.positions;
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (model.pinned[v]) {
      state.positions[v] -= timeStep * velocity_;
    }
  }
  shift(model, Vec3::Zero(), -velocity_, state.positions, state.velocities);
  StepHistory& before = state.history;
  if (before.timeStep > 0.0 && before.positions.size() == model.pinned.size()) {
    shift(model, before.timeStep * velocity_, -velocity_, before.positions, before.velocities);
  }
}

void MovingFrame::leave(const ClothModel& model, double timeStep, ClothState& state) const {
  if (!moves_) {
    return;
  }
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (model.pinned[v]) {
      state.positions[v] = startPositions_[v];
    }
  }
  shift(model, timeStep * velocity_, velocity_, state.positions, state.velocities);
  if (state.history.timeStep > 0.0) {  // the history is now that of the start of this step
    shift(model, Vec3::Zero(), velocity_, state.history.positions, state.history.velocities);
  }
}

}  // namespace drape::sim
