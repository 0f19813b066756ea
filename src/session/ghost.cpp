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

/// Takes the pieces and the seams of the first cloth, with the welds of the ghost.
void Ghost::useCloth(const sim::SewnCloth& first) {
  if (cloth_.seams() != first.seams() && cloth_.pieces()) {
    cloth_.sew(first.pieces(), first.seams(), state_);
  } else if (cloth_.pieces() != first.pieces()) {
    cloth_ = first;
  }
  cloth_.follow(state_);
}

bool Ghost::step(const sim::SewnCloth& cloth, const settings::Settings& settings, const sim::StepInputs& inputs) {
  const auto before = std::chrono::steady_clock::now();
  useCloth(cloth);
  const sim::StepParameters parameters = cloth_.acting(ghostParameters(settings), state_.time);
  stepper_.drawTogether(cloth_.openSeams());
  report_ = stepper_.step(*cloth_.model(), parameters, inputs, state_);
  if (cloth_.hasSeams()) {
    cloth_.weld(sim::weldDistanceOf(*cloth_.model(), parameters.contact, solver()), state_);
  }
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
