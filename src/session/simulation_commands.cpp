#include "session/simulation.hpp"

#include "intersection/intersections.hpp"
#include "messages/sim_error_text.hpp"
#include "scene/cloth_material.hpp"
#include "scene/mass.hpp"
#include "scene/sewing.hpp"
#include "session/pin_places.hpp"
#include "session/solver_warning.hpp"
#include "settings/surface_fields.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/motion/unfolding.hpp"
#include "sim/stepping/untangling.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace drape::session {

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
    const auto weighed = scene::withMasses(*cloth_.pieces(), cloths_, changed);
    // A fabric's highest frequency depends on the masses.
    changeCloth(scene::withElasticity(*weighed, cloths_, changed));
  } else if (effect == settings::SettingEffect::Fabric) {
    changeCloth(scene::withMaterial(*cloth_.pieces(), cloths_, changed));
  }
  settings_ = std::move(changed);
  timeline_.limit(settings_.timeline.memory);
  useSolvers();
  useBalance();
  useAccuracyCheck();
  message_ = {};
}

void Simulation::on(const PauseCommand& command) {
  paused_ = command.paused;
}

void Simulation::on(const SingleStepCommand&) {
  paused_ = true;
  step();
}

void Simulation::on(const ResetCommand&) {
  startSeams([](const sim::Seam& /*seam*/) { return 0.0; });
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
  overlapMessage_ = {};
  blewUp_ = false;
  stepIndex_ = 0;
  inputs_.attachment.reset();
  message_ = unfolded ? text::Sentence(
                            "The cloth starts folded flat. Drape added a millionth of its rest shape, so that "
                            "it can unfold.")
                      : text::Sentence();
}

/// Stops after a limited time: parts that pins hold in each other stay as they are.
void Simulation::on(const UntangleCommand&) {
  constexpr double maxSeconds = 4.0;
  sim::Untangling untangling(model_, state_.positions, settings_.step);
  untangling.openFlatLayers(intersection::intersectingPairs({state_.positions, model_->triangles}));
  while (!untangling.isDone() && untangling.time() < maxSeconds) {
    untangling.step();
    sim::checkStop(inputs_);
  }
  restAt(untangling.positions());
  message_ = untangling.isDone()
                 ? text::Sentence()
                 : text::Sentence("Untangling did not remove all intersections. Pins may hold parts in each other.");
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
  if (command.isStart && command.positions.empty()) {
    placedStart_ = nullptr;
    on(ResetCommand{});
    return;
  }
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
    overlapMessage_ = {};
    lastOutside_ = state_.time;
    message_ = {};
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
    throw messages::InputError("Hold the cloth with the mouse, or select vertices (B), then press P to pin them.");
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

void Simulation::on(const SetPinPathsCommand& command) {
  std::vector<bool> isTaken(model_->pinned.size(), false);
  for (const scene::PinPath& path : command.paths) {
    if (const auto fault = scene::faultOf(path.motion)) {
      throw messages::InputError(*fault);
    }
    for (const int vertex : path.vertices) {
      if (isTaken[requireVertex(vertex)]) {
        throw messages::InputError("the vertex " + std::to_string(vertex) + " has keyframes twice");
      }
      isTaken[vertex] = true;
    }
  }
  if (command.moves) {
    const PinMoves moves = movesBetween(*pinPaths_, command.paths, *model_, state_);
    if (!moves.vertices.empty()) {
      on(PlacePinsCommand{moves.vertices, moves.places});
    }
  }
  pinPaths_ = std::make_shared<const std::vector<scene::PinPath>>(command.paths);
}

void Simulation::on(const SetSewingCommand& command) {
  std::shared_ptr<const sim::ClothModel> pieces = cloth_.pieces();
  std::vector<scene::ClothPart> cloths = cloths_;
  if (command.sewing.bands != sewing_->bands) {
    cloths = scene::withBands(*scene_, command.sewing.bands);
    pieces = scene::withBandsOf(cloths, *pieces, settings_);
  }
  if (command.sewing.seams == sewing_->seams) {
    changeCloth(std::move(pieces));
  } else {
    auto seams = std::make_shared<const std::vector<sim::Seam>>(seamsFor(command.sewing, *pieces));
    cloth_.sew(std::move(pieces), std::move(seams), state_);
    model_ = cloth_.model();
  }
  cloths_ = std::move(cloths);
  sewing_ = std::make_shared<const scene::Sewing>(command.sewing);
  message_ = {};
}

std::vector<sim::Seam> Simulation::seamsFor(const scene::Sewing& sewing, const sim::ClothModel& pieces) const {
  std::vector<sim::Seam> seams;
  for (const scene::SeamDescription& description : sewing.seams) {
    const auto known = std::ranges::find(sewing_->seams, description);
    if (known == sewing_->seams.end()) {
      sim::Seam seam = scene::seamOf(description, *scene_, pieces, seams);
      seam.start = state_.time;
      seams.push_back(std::move(seam));
    } else {
      seams.push_back((*cloth_.seams())[known - sewing_->seams.begin()]);
    }
  }
  return seams;
}

void Simulation::startSeams(const std::function<double(const sim::Seam& seam)>& startOf) {
  std::vector<sim::Seam> seams = *cloth_.seams();
  for (sim::Seam& seam : seams) {
    seam.start = startOf(seam);
  }
  if (!std::ranges::equal(seams, *cloth_.seams(), {}, &sim::Seam::start, &sim::Seam::start)) {
    cloth_.sew(cloth_.pieces(), std::make_shared<const std::vector<sim::Seam>>(std::move(seams)), state_);
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
  accuracy_.reset();  // before the bodies of the present scene are gone
  scene_ = command.scene;
  placedStart_.reset();
  pinPaths_ = std::make_shared<const std::vector<scene::PinPath>>(scene_->pinPaths);
  sewing_ = std::make_shared<const scene::Sewing>(scene::sewingOf(scene_->description));
  cloths_ = scene_->cloths;
  cloth_.use(scene_->model, scene_->seams);
  model_ = cloth_.model();
  settings_ = scene_->settings;
  ghost_.reset();
  timeline_.clear();
  timeline_.limit(settings_.timeline.memory);
  budget_ = {};
  bodies_ = sim::contact::BodyWorld(scene_->bodies, scene_->start.time);
  on(ResetCommand{});
  stepper_.reset();  // it knows bodies by their addresses, which those of the next scene may have
  useSolvers();
  useBalance();
  useAccuracyCheck();
  // The log starts again: its commands belong to the previous scene.
  log_.clear();
  stepsTaken_ = 0;
}

}  // namespace drape::session
