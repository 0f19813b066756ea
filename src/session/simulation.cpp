#include "session/simulation.hpp"

#include "messages/sim_error_text.hpp"
#include "scene/cloth_material.hpp"
#include "scene/mass.hpp"
#include "session/pin_places.hpp"
#include "session/solver_warning.hpp"
#include "settings/surface_fields.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/forces/attachment_limit.hpp"
#include "sim/motion/unfolding.hpp"
#include "sim/stepping/untangling.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace drape::session {

Simulation::Simulation(std::shared_ptr<const scene::Scene> scene) {
  on(LoadSceneCommand{std::move(scene)});
}

void Simulation::apply(const Command& command) {
  log_.push_back({stepsTaken_, command});
  ++version_;
  try {
    std::visit([this](const auto& each) { on(each); }, command);
  } catch (const messages::InputError& error) {
    message_ = error.what();
  } catch (const sim::SimError& error) {
    message_ = messages::messageOf(error);
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
  inputs_.onProgress = onProgress_ ? &onProgress_ : nullptr;
  stepper_->keepContactWork(balance_.has_value());
  stepper_->keepContactLoads(isObserved());
  stepper_->drawTogether(cloth_.openSeams());
  const sim::StepParameters parameters = cloth_.acting(settings_.step, state_.time);
  stepReport_ = stepper_->step(*model_, parameters, inputs_, state_);
  stepSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  ++version_;
  blewUp_ = !sim::isFinite(state_);
  if (blewUp_) {
    state_ = lastFinite_;
    paused_ = true;
    message_ = "The cloth blew up at " + std::to_string(state_.time) + " s and stopped. Use a smaller time step or " +
               (model_->fabric ? "a softer fabric" : "a lower stiffness") + ", then reset.";
    return;
  }
  if (balance_) {
    balance_->add(*model_, parameters, inputs_, lastFinite_, state_, stepper_->contact().unresolved(),
                  {stepper_->earlierContactWork(), stepper_->dampingWork()});
  }
  stepGhost();
  reportOverlap();
  closeSeams();
  ++stepIndex_;
  ++stepsTaken_;
  updateCostBudget();
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
  overlapMessage_.clear();
  if (contact.overlaps == 0 || stepIndex_ == 0) {
    lastOutside_ = state_.time;
  }
  if (contact.overlaps > 0) {
    const bool stuck = state_.time - lastOutside_ > patience;
    const double depth = contact.deepestOverlap * 1e3;
    overlapMessage_ = fmt::format(
        "The cloth {} inside a body ({} triangles, up to {:.{}f} mm deep) and {}",
        stepIndex_ == 0 ? "starts"
        : stuck         ? "is still"
                        : "is",
        contact.overlaps, depth, depth < 10.0 ? 1 : 0,
        stuck ? "contact cannot push it out: the body may cross the cloth, or not fit. Move or scale one of them."
              : "is pushed out slowly.");
  }
}

void Simulation::stepGhost() {
  if (ghost_ && !ghost_->step(cloth_, settings_, inputs_)) {
    message_ = "The ghost (" + std::string(ghost_->solver().title) + ") blew up at " + std::to_string(state_.time) +
               " s and was removed. Use more substeps, or another solver for it.";
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
  message_.clear();
  ++version_;
}

void Simulation::capture(Snapshot& snapshot) const {
  snapshot.scene = scene_;
  snapshot.model = cloth_.pieces();
  snapshot.positions = state_.positions;
  snapshot.placedStart = placedStart_;
  snapshot.step = stepIndex_;
  snapshot.version = version_;
  snapshot.time = state_.time;
  snapshot.settings = settings_;
  snapshot.paused = paused_;
  snapshot.energy = sim::energyOf(*model_, settings_.step, state_);
  snapshot.balance = balance_;
  snapshot.maxStretch = sim::maxStretch(*model_, state_);
  snapshot.stepSeconds = stepSeconds_;
  snapshot.stepReport = stepReport_;
  snapshot.message = message();
  snapshot.overstretched.reset();
  if (snapshot.maxStretch > implausibleStretch) {
    snapshot.overstretched = diagnoseStretch(*scene_, settings_, *model_, state_, inputs_.attachment.has_value());
    if (snapshot.message.empty()) {
      snapshot.message = snapshot.overstretched->advice.text;
    }
  }
  if (!ghost_) {
    snapshot.ghost.reset();
  } else {
    ghost_->capture(state_, snapshot.ghost ? *snapshot.ghost : snapshot.ghost.emplace());
  }
  captureBodies(snapshot);
  captureContact(snapshot);
  captureForFields(snapshot);
  snapshot.timeline = timeline_.status(settings_.step.timeStep);
  snapshot.attachment.reset();
  if (inputs_.attachment) {
    const sim::AttachedCorners corners = sim::attachedCorners(*model_, *inputs_.attachment);
    snapshot.attachment =
        AttachmentStatus{static_cast<const sim::AttachmentEnds&>(*inputs_.attachment),
                         corners.interpolatedFrom(state_.positions), model_->pinned[corners.nearestVertex()]};
  }
}

void Simulation::captureBodies(Snapshot& snapshot) const {
  snapshot.bodies.resize(bodies_.bodies().size());
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    BodyStatus& status = snapshot.bodies[i];
    status.pose = bodies_.pose(i);
    status.shift = bodies_.shift(i);
    status.targetShift = bodies_.targetShift(i);
    status.on = bodies_.isOn(i);
    status.surface = bodies_.surface(i);
    status.figure.reset();
    if (const auto figure = figureAt(i)) {
      status.figure = figure->options();
    }
    status.vertices.clear();
    if (bodies_.isDeforming(i)) {
      const auto vertices = bodies_.vertices(i);
      status.vertices.assign(vertices.begin(), vertices.end());
    }
  }
}

void Simulation::captureContact(Snapshot& snapshot) const {
  snapshot.contactPoints.clear();
  if (settings_.view.contacts) {
    const auto points = stepper_->contact().points();
    snapshot.contactPoints.assign(points.begin(), points.end());
  }
  snapshot.intersections.clear();
  if (settings_.view.intersections && !state_.hasNoSelfIntersection && sim::isFinite(state_)) {
    intersections_->find(*model_, state_.positions, snapshot.intersections);
  }
}

void Simulation::captureForFields(Snapshot& snapshot) const {
  snapshot.velocities.clear();
  snapshot.contactImpulses.clear();
  if (!isObserved()) {
    return;
  }
  snapshot.velocities = state_.velocities;
  cloth_.spread<Vec3>(snapshot.velocities);
  // A new scene, a reset or another solver has no last step.
  if (stepIndex_ > 0 && stepper_->contactLoads().known()) {
    snapshot.contactImpulses = stepper_->contactLoads().impulses();
    snapshot.contactImpulses.resize(state_.positions.size(), 0.0);
    cloth_.spread<double>(snapshot.contactImpulses);
  }
}

void Simulation::on(const SetSettingCommand& command) {
  const settings::SettingInfo& info = settings::requireSetting(command.key);
  if (info.effect == settings::SettingEffect::Scene) {
    throw messages::InputError(command.key + " takes effect when the scene is built again");
  }
  useSettings(settings::withSetting(settings_, info, command.value), info.effect);
}

void Simulation::on(const UseFabricCommand& command) {
  settings::Settings changed = settings_;
  settings::useFabric(changed, command.fabric);
  settings::requireFabricValues(changed);
  useSettings(std::move(changed), settings::SettingEffect::Fabric);
}

void Simulation::on(const SetOwnFabricsCommand& command) {
  settings_.fabric.own = command.fabrics;
}

/// Replaces the settings, and the parts of the model that depend on them.
void Simulation::useSettings(settings::Settings changed, settings::SettingEffect effect) {
  requireSolversForMaterial(changed);
  if (effect == settings::SettingEffect::Mass) {
    const auto weighed = scene::withMasses(*cloth_.pieces(), scene_->cloths, changed);
    // A fabric's highest frequency depends on the masses.
    changeCloth(scene::withElasticity(*weighed, scene_->cloths, changed));
  } else if (effect == settings::SettingEffect::Fabric) {
    changeCloth(scene::withMaterial(*cloth_.pieces(), scene_->cloths, changed));
  }
  settings_ = std::move(changed);
  timeline_.limit(settings_.timeline.memory);
  useSolvers();
  useBalance();
  message_.clear();
}

void Simulation::on(const PauseCommand& command) {
  paused_ = command.paused;
}

void Simulation::on(const SingleStepCommand&) {
  paused_ = true;
  step();
}

void Simulation::on(const ResetCommand&) {
  state_ = scene_->start;
  if (placedStart_) {
    state_ = sim::stateAtRest(*placedStart_);
    state_.time = scene_->start.time;
  }
  followState();
  const bool unfolded = sim::makeUnfoldable(*model_, state_);
  restartFigures();
  cloth_.carry(state_);
  bodies_.reset(state_.time);
  if (ghost_) {
    ghost_->reset(state_);
  }
  if (balance_) {
    balance_.emplace();
  }
  stepReport_ = {};
  overlapMessage_.clear();
  blewUp_ = false;
  stepIndex_ = 0;
  inputs_.attachment.reset();
  message_ =
      unfolded ? "The cloth starts folded flat. Drape added a millionth of its rest shape, so that it can unfold." : "";
}

/// Stops after a limited time: parts that pins hold in each other stay as they are.
void Simulation::on(const UntangleCommand&) {
  constexpr double maxSeconds = 4.0;
  sim::Untangling untangling(model_, state_.positions, settings_.step);
  while (!untangling.isDone() && untangling.time() < maxSeconds) {
    untangling.step();
    sim::checkStop(inputs_);
  }
  restAt(untangling.positions());
  message_ =
      untangling.isDone() ? "" : "Untangling did not remove all intersections. Pins may hold parts in each other.";
}

/// Goes on from other positions at the present time.
void Simulation::restAt(std::vector<Vec3> positions) {
  const double time = state_.time;
  state_ = sim::stateAtRest(std::move(positions));
  state_.time = time;
  followState();
  if (ghost_) {
    ghost_->reset(state_);
  }
  if (balance_) {
    balance_.emplace();
  }
  stepReport_ = {};
}

void Simulation::on(const PlaceClothCommand& command) {
  const bool isFinite = std::ranges::all_of(command.positions, [](const Vec3& each) { return each.allFinite(); });
  if (static_cast<int>(command.positions.size()) != model_->vertexCount() || !isFinite) {
    throw messages::InputError("the cloth needs one finite place for each vertex");
  }
  if (command.isStart) {
    placedStart_ = std::make_shared<const std::vector<Vec3>>(command.positions);
    on(ResetCommand{});
  } else {
    restAt(command.positions);
    inputs_.attachment.reset();
    overlapMessage_.clear();
    lastOutside_ = state_.time;
    message_.clear();
  }
}

void Simulation::on(const AttachCommand& command) {
  const bool exists = command.triangle >= 0 && command.triangle < static_cast<int>(model_->triangles.size());
  const bool inside = command.barycentric.allFinite() && (command.barycentric.array() >= -1e-6).all() &&
                      std::abs(command.barycentric.sum() - 1.0) < 1e-6;
  if (!exists || !inside || !command.target.allFinite()) {
    throw messages::InputError("the attachment needs a point of the cloth");
  }
  inputs_.attachment = sim::Attachment{command, settings_.attachment};
}

void Simulation::on(const MoveAttachmentCommand& command) {
  if (inputs_.attachment && command.target.allFinite()) {
    inputs_.attachment->target = command.target;
  }
}

void Simulation::on(const DetachCommand&) {
  inputs_.attachment.reset();
}

void Simulation::on(const TogglePinCommand&) {
  if (!inputs_.attachment) {
    throw messages::InputError("Hold the cloth with the mouse, then press P to pin it there.");
  }
  const std::size_t nearest = sim::attachedCorners(*model_, *inputs_.attachment).nearestVertex();
  const bool pins = !model_->pinned[nearest];
  std::vector<bool> pinned = cloth_.pieces()->pinned;
  for (const int vertex : cloth_.weldedTo(static_cast<int>(nearest))) {
    pinned[vertex] = false;
  }
  pinned[nearest] = pins;
  changeCloth(sim::withPins(*cloth_.pieces(), std::move(pinned)));
}

void Simulation::on(const SetPinsCommand& command) {
  std::vector<bool> pinned(model_->pinned.size(), false);
  for (const int vertex : command.vertices) {
    pinned[requireVertex(vertex)] = true;
  }
  changeCloth(sim::withPins(*cloth_.pieces(), std::move(pinned)));
}

void Simulation::on(const PlacePinsCommand& command) {
  if (command.vertices.size() != command.places.size()) {
    throw messages::InputError("every pin needs a place");
  }
  for (std::size_t i = 0; i < command.vertices.size(); ++i) {
    if (!model_->pinned[requireVertex(command.vertices[i])] || !command.places[i].allFinite()) {
      throw messages::InputError("only pinned vertices can be placed, at finite places");
    }
  }
  placeVertices(command.vertices, command.places, state_);
  cloth_.carry(state_);
  if (ghost_) {
    ghost_->placePins(command.vertices, command.places);
  }
}

void Simulation::on(const MovePinsCommand& command) {
  if (!command.by.allFinite()) {
    throw messages::InputError("pins can only be moved by finite distances");
  }
  if (std::ranges::none_of(sim::fabric::ownPinsOf(*model_), std::identity{})) {
    throw messages::InputError("there are no pins to move");
  }
  sim::movePins(sim::fabric::ownPinsOf(*model_), command.by, state_);
  cloth_.carry(state_);
  if (ghost_) {
    ghost_->movePins(*model_, command.by);
  }
}

void Simulation::on(const SwitchBodyCommand& command) {
  bodies_.switchOn(requireBody(command.body), command.on);
}

void Simulation::on(const SetSurfaceCommand& command) {
  const std::size_t body = requireBody(command.body);
  settings::requireAllowed(command.surface);
  bodies_.setSurface(body, command.surface);
}

void Simulation::on(const MoveBodyCommand& command) {
  const std::size_t body = requireBody(command.body);
  if (command.shift.allFinite()) {
    bodies_.shiftTowards(body, command.shift);
  }
}

void Simulation::on(const SetFigureCommand& command) {
  const std::size_t body = requireBody(command.body);
  const auto figure = figureAt(body);
  if (!figure) {
    throw messages::InputError("the body \"" + bodies_.bodies()[body].name + "\" is not a figure");
  }
  if (!figure::isAllowed(command.figure)) {
    throw messages::InputError("the speed or a measure of the figure is outside its range");
  }
  if (command.figure != figure->options()) {
    bodies_.deform(body,
                   stepIndex_ == 0 ? figure->restarted(command.figure) : figure->changed(state_.time, command.figure));
  }
}

/// The figure that a body is; null for other bodies.
std::shared_ptr<const figure::MovingFigure> Simulation::figureAt(std::size_t body) const {
  return figure::asFigure(bodies_.deformation(body));
}

/// Figures keep the user's motion and proportions, and begin them in the rest pose.
void Simulation::restartFigures() {
  for (std::size_t i = 0; i < bodies_.bodies().size(); ++i) {
    if (const auto figure = figureAt(i)) {
      bodies_.deform(i, figure->restarted(figure->options()));
    }
  }
}

std::size_t Simulation::requireVertex(int vertex) const {
  if (vertex < 0 || vertex >= model_->vertexCount()) {
    throw messages::InputError("there is no vertex " + std::to_string(vertex) + " in this cloth");
  }
  return static_cast<std::size_t>(vertex);
}

std::size_t Simulation::requireBody(int body) const {
  if (body < 0 || body >= static_cast<int>(bodies_.bodies().size())) {
    throw messages::InputError("there is no body " + std::to_string(body) + " in this scene");
  }
  return static_cast<std::size_t>(body);
}

void Simulation::on(const SetCostBudgetCommand& command) {
  settings::assignSetting(settings_, settings::requireSetting("auto.cost"), command.costBudget);
}

void Simulation::on(const ObserveCommand& command) {
  observed_ = command.on;
}

RecordedState Simulation::recorded() const {
  return {stepIndex_, state_, ghost_ ? std::optional(ghost_->state()) : std::nullopt, bodies_.shifts()};
}

/// The figures were where the recorded state has them. From there they do what the user chose since.
void Simulation::continueFrom(const RecordedState& recorded) {
  const std::vector<sim::contact::BodyShift> bodies = recorded.bodies;
  std::vector<std::shared_ptr<const figure::MovingFigure>> chosen;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    chosen.push_back(figureAt(i));
  }
  const sim::ClothState ghost = recorded.ghost.value_or(recorded.state);
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
  overlapMessage_.clear();
}

void Simulation::on(const GoToCommand& command) {
  if (!std::isfinite(command.time) || timeline_.at(stepIndex_) == nullptr) {
    throw messages::InputError("there is no recorded state; see timeline.memory");
  }
  if (timeline_.at(std::numeric_limits<std::int64_t>::max())->step < stepIndex_) {
    timeline_.record(recorded());  // so that the user can come back
  }
  continueFrom(timeline_.nearest(command.time));
  paused_ = true;
}

void Simulation::on(const StepBackCommand&) {
  const RecordedState* before = timeline_.at(stepIndex_ - 1);
  if (before == nullptr || before->step >= stepIndex_) {
    throw messages::InputError("there is no recorded state before this one");
  }
  on(GoToCommand{before->state.time});
}

void Simulation::on(const LoadSceneCommand& command) {
  if (!command.scene) {
    throw messages::InputError("there is no scene to load");
  }
  requireSolversForMaterial(command.scene->settings);
  scene_ = command.scene;
  placedStart_.reset();
  cloth_.use(scene_->model, scene_->seams);
  model_ = cloth_.model();
  settings_ = scene_->settings;
  ghost_.reset();
  timeline_.clear();
  timeline_.limit(settings_.timeline.memory);
  budget_ = {};
  bodies_ = sim::contact::BodyWorld(scene_->bodies, scene_->start.time);
  on(ResetCommand{});
  useSolvers();
  useBalance();
  // The log starts again: its commands belong to the previous scene.
  log_.clear();
  stepsTaken_ = 0;
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

/// The mouse spring follows the settings, and the cloth limits its force.
void Simulation::limitAttachment() {
  if (inputs_.attachment) {
    sim::Attachment& attachment = *inputs_.attachment;
    static_cast<sim::AttachmentSpring&>(attachment) = settings_.attachment;
    attachment.maxForce = std::min(attachment.maxForce, sim::maxAttachmentForce(*model_, settings_.step, attachment));
  }
}

}  // namespace drape::session
