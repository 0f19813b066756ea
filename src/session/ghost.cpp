#include "session/ghost.hpp"

#include "sim/measures/measures.hpp"

#include <chrono>

namespace drape::session {

void Ghost::useSolver(const std::string& name) {
  if (solver().name != name) {
    stepper_ = sim::Stepper(name);
    report_ = {};
  }
}

void Ghost::reset(const sim::ClothState& start) {
  state_ = start;
  report_ = {};
}

bool Ghost::step(const sim::ClothModel& model, const settings::Settings& settings, const sim::StepInputs& inputs) {
  const auto before = std::chrono::steady_clock::now();
  report_ = stepper_.step(model, ghostParameters(settings), inputs, state_);
  stepSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  return sim::isFinite(state_);
}

void Ghost::capture(const sim::ClothState& first, GhostStatus& status) const {
  status.positions = state_.positions;
  status.meanDistance = sim::meanDistance(first.positions, state_.positions);
  status.stepSeconds = stepSeconds_;
  status.stepReport = report_;
}

sim::StepParameters ghostParameters(const settings::Settings& settings) {
  sim::StepParameters parameters = settings.step;
  parameters.substeps = settings.ghost.substeps;
  return parameters;
}

}  // namespace drape::session
