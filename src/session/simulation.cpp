#include "session/simulation.hpp"

#include "messages/sim_error_text.hpp"
#include "sim/forces/attachment_limit.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

namespace drape::session {

Simulation::Simulation(std::shared_ptr<const scene::Scene> scene) {
  on(LoadSceneCommand{std::move(scene)});
}

void Simulation::apply(const Command& command) {
  log_.push_back({stepsTaken_, command});
  noteChange();
  try {
    std::visit([this](const auto& each) { on(each); }, command);
  } catch (const messages::InputError& error) {
    message_ = messages::sentenceOf(error);
  } catch (const sim::SimError& error) {
    message_ = messages::sentenceOf(error);
  }
}

void Simulation::step() {
  if (timeline_.isDue(stepIndex_, settings_.step.timeStep)) {
    timeline_.record(recorded());
  }
  lastFinite_ = state_;
  const auto before = std::chrono::steady_clock::now();
  limitAttachment();
  bodies_.advance(state_.time, settings_.step.timeStep);
  inputs_.bodies = &bodies_.steps();
  movedPins_ = scene::movedPins(*pinPaths_, state_.positions, state_.time, settings_.step.timeStep);
  inputs_.movedPins = movedPins_.empty() ? nullptr : &movedPins_;
  inputs_.onProgress = onProgress_ ? &onProgress_ : nullptr;
  stepper_->keepContactWork(balance_.has_value());
  stepper_->keepContactLoads(isObserved());
  stepper_->drawTogether(cloth_.openSeams());
  const sim::StepParameters parameters = cloth_.acting(settings_.step, state_.time);
  stepReport_ = stepper_->step(*model_, parameters, inputs_, state_);
  stepSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  ++version_;
  pictureVersion_ += isStill() ? 0 : 1;
  blewUp_ = !sim::isFinite(state_);
  if (blewUp_) {
    state_ = lastFinite_;
    paused_ = true;
    message_ = text::Sentence(
        model_->fabric
            ? "The cloth blew up at {} s and stopped. Use a smaller time step or a softer fabric, then reset."
            : "The cloth blew up at {} s and stopped. Use a smaller time step or a lower stiffness, then reset.",
        std::to_string(state_.time));
    return;
  }
  if (balance_) {
    balance_->add(*model_, parameters, inputs_, lastFinite_, state_, stepper_->contact().unresolved(),
                  {.earlierContact = stepper_->earlierContactWork(),
                   .damping = stepper_->dampingWork(),
                   .unsteadyAir = stepper_->unsteadyAirWork()});
  }
  stepGhost();
  checkAccuracy();
  reportOverlap();
  closeSeams();
  ++stepIndex_;
  ++stepsTaken_;
  updateCostBudget();
}

void Simulation::noteChange() {
  ++version_;
  ++pictureVersion_;
}

/// Whether nothing has moved in the last step. Cloth sleeps only while all bodies are still.
bool Simulation::isStill() const {
  return stepReport_.choice && stepReport_.choice->sleeping && !ghost_;
}

/// Welds the seams that are closed.
void Simulation::closeSeams() {
  if (!cloth_.hasSeams()) {
    return;
  }
  const double distance = sim::weldDistanceOf(*model_, settings_.step.contact, stepper_->info());
  if (cloth_.weld(distance, state_)) {
    model_ = cloth_.model();
  }
}

void Simulation::changeCloth(std::shared_ptr<const sim::ClothModel> pieces) {
  cloth_.change(std::move(pieces));
  model_ = cloth_.model();
}

void Simulation::followState() {
  cloth_.follow(state_);
  model_ = cloth_.model();
}

void Simulation::updateCostBudget() {
  if (replaying_) {
    return;
  }
  if (const auto budget = budget_.budgetAfter(settings_, *model_, stepReport_, stepSeconds_)) {
    apply(SetCostBudgetCommand{*budget});
  }
}

/// Reports cloth inside a body, which contact pushes out slowly.
void Simulation::reportOverlap() {
  constexpr double patience = 1.5;  // contact pushes nearly everything out within this time [s]
  const sim::contact::ContactReport& contact = stepReport_.contact;
  overlapMessage_ = {};
  if (contact.overlaps == 0 || stepIndex_ == 0) {
    lastOutside_ = state_.time;
  }
  if (contact.overlaps > 0) {
    const bool stuck = state_.time - lastOutside_ > patience;
    const double depth = contact.deepestOverlap * 1e3;
    const text::Sentence triangles(text::plural(contact.overlaps, "{} triangle", "{} triangles"), contact.overlaps);
    overlapMessage_ = text::Sentence(
        stepIndex_ == 0 ? "The cloth starts inside a body ({}, up to {} mm deep) and is pushed out slowly."
        : stuck         ? "The cloth is still inside a body ({}, up to {} mm deep) and contact cannot push it out: the "
                          "body may cross the cloth, or not fit. Move or scale one of them."
                        : "The cloth is inside a body ({}, up to {} mm deep) and is pushed out slowly.",
        triangles, fmt::format("{:.{}f}", depth, depth < 10.0 ? 1 : 0));
  }
}

void Simulation::stepGhost() {
  if (ghost_ && !ghost_->step(cloth_, settings_, inputs_)) {
    message_ =
        text::Sentence("The ghost ({}) blew up at {} s and was removed. Use more substeps, or another solver for it.",
                       text::Sentence(ghost_->solver().title), std::to_string(state_.time));
    settings_.ghost.solver = "off";
    useSolvers();
  }
}

void Simulation::replay(const std::vector<LoggedCommand>& log, std::int64_t steps,
                        const std::function<void()>& afterStep) {
  replaying_ = true;
  std::int64_t seen = stepsTaken_;
  const auto notify = [&] {
    if (afterStep && stepsTaken_ != seen) {
      afterStep();
    }
    seen = stepsTaken_;
  };
  // A step that blows up is undone. Without the check it would repeat forever.
  const auto stepTo = [&](std::int64_t end) {
    for (bool goesOn = true; goesOn && stepsTaken_ < end; goesOn = !blewUp_) {
      step();
      notify();
    }
  };
  for (const LoggedCommand& entry : log) {
    stepTo(entry.step);
    apply(entry.command);
    notify();
  }
  stepTo(steps);
  replaying_ = false;
}

void Simulation::continueFrom(sim::ClothState state, std::int64_t step) {
  state_ = std::move(state);
  followState();
  stepIndex_ = step;
  stepReport_ = {};
  stepper_->keepContactLoads(false);  // forgets those of the last step
  lastOutside_ = state_.time;
  blewUp_ = false;
  bodies_.reset(state_.time);
  if (ghost_) {
    ghost_->reset(state_);
  }
  if (balance_) {
    balance_.emplace();
  }
  message_ = {};
  noteChange();
}

RecordedState Simulation::recorded() const {
  return {stepIndex_, state_, ghost_ ? std::optional(ghost_->state()) : std::nullopt, bodies_.shifts(), cloth_.seams()};
}

/// The figures were where the recorded state has them. From there they do what the user chose since.
void Simulation::continueFrom(const RecordedState& recorded) {
  const std::vector<sim::contact::BodyShift> bodies = recorded.bodies;
  std::vector<std::shared_ptr<const figure::MovingFigure>> chosen;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    chosen.push_back(figureAt(i));
  }
  const sim::ClothState ghost = recorded.ghost.value_or(recorded.state);
  // A seam that was not there then is drawn together from there.
  startSeams([&, known = recorded.seams](const sim::Seam& seam) {
    const auto end = known ? known->end() : std::vector<sim::Seam>::const_iterator();
    const auto found = known ? std::ranges::find(*known, seam.pairs, &sim::Seam::pairs) : end;
    return found == end ? recorded.state.time : found->start;
  });
  continueFrom(recorded.state, recorded.step);
  bodies_.resume(state_.time, bodies);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) {
      on(SetFigureCommand{static_cast<int>(i), chosen[i]->options()});
    }
  }
  if (ghost_) {
    ghost_->reset(ghost);
  }
  inputs_.attachment.reset();
  overlapMessage_ = {};
}

/// Creates the solvers that the settings name. The states do not change.
void Simulation::useSolvers() {
  if (!stepper_ || stepper_->info().name != settings_.solver.name) {
    stepper_ = std::make_unique<sim::Stepper>(settings_.solver.name);
    stepReport_ = {};
  }
  const std::string& ghost = settings_.ghost.solver;
  if (ghost == "off") {
    ghost_.reset();
  } else if (ghost_) {
    ghost_->useSolver(ghost);
  } else {
    ghost_.emplace(ghost, state_);
  }
}

/// The energy balance starts when the setting is switched on.
void Simulation::useBalance() {
  if (!settings_.measures.energyBalance) {
    balance_.reset();
  } else if (!balance_) {
    balance_.emplace();
  }
}

void Simulation::useAccuracyCheck() {
  if (!settings_.measures.errorCheck) {
    accuracy_.reset();
  } else if (!accuracy_) {
    accuracy_ = std::make_unique<AccuracyCheck>(accuracyInBackground_);
  }
}

void Simulation::setAccuracyInBackground(bool inBackground) {
  accuracyInBackground_ = inBackground;
  accuracy_.reset();
  useAccuracyCheck();
}

/// Sleeping cloth has no error that is worth a check.
void Simulation::checkAccuracy() {
  const bool sleeps = stepReport_.choice && stepReport_.choice->sleeping;
  if (accuracy_ && !sleeps) {
    accuracy_->follow(cloth_, settings_, inputs_, lastFinite_, state_);
  }
}

/// The mouse spring follows the settings, and the cloth limits its force.
void Simulation::limitAttachment() {
  if (inputs_.attachment) {
    sim::Attachment& attachment = *inputs_.attachment;
    static_cast<sim::AttachmentSpring&>(attachment) = settings_.attachment;
    attachment.maxForce = std::min(attachment.maxForce, sim::maxAttachmentForce(*model_, settings_.step, attachment));
  }
}

}  // namespace drape::session
