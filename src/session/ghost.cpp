#include "session/ghost.hpp"

#include "sim/measures/measures.hpp"

#include <chrono>

namespace drape {

void Ghost::useSolver(const std::string& name) {
  if (solver().name != name) {
    stepper_ = Stepper(name);
    report_ = {};
  }
}

void Ghost::reset(const ClothState& start) {
  state_ = start;
  report_ = {};
}

bool Ghost::step(const ClothModel& model, const Settings& settings, const StepInputs& inputs) {
  const auto before = std::chrono::steady_clock::now();
  report_ = stepper_.step(model, ghostParameters(settings), inputs, state_);
  stepSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  return isFinite(state_);
}

void Ghost::capture(const ClothState& first, GhostStatus& status) const {
  status.positions = state_.positions;
  status.meanDistance = meanDistance(first.positions, state_.positions);
  status.stepSeconds = stepSeconds_;
  status.stepReport = report_;
}

StepParameters ghostParameters(const Settings& settings) {
  StepParameters parameters = settings.step;
  parameters.substeps = settings.ghost.substeps;
  return parameters;
}

}  // namespace drape
