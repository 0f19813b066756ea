// Dressing in the window, and bodies that pass through the cloth.
#include "app/viewer/viewer.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace drape::app {
namespace {

using dressing::PlacedBody;
using dressing::PlacementRule;

double sizeOf(const PlacedBody& body) {
  return sim::boundsOf(body.mesh.positions).sizes().norm();
}

/// The body to dress: the one that passes through the cloth most, else the largest that can be dressed, else the
/// largest. Null if there is none.
const PlacedBody* bodyToDress(const std::vector<PlacedBody>& bodies, const session::Snapshot& snapshot,
                              const std::vector<dressing::Piercing>& piercings) {
  std::vector<const PlacedBody*> candidates;
  for (const PlacedBody& body : bodies) {
    if ((*snapshot.scene->bodies)[body.body].drawn) {
      candidates.push_back(&body);
    }
  }
  std::ranges::stable_sort(candidates, std::greater(), [](const PlacedBody* body) { return sizeOf(*body); });
  const sim::ClothMesh cloth{snapshot.positions, snapshot.model->triangles};
  std::stable_partition(candidates.begin(), candidates.end(), [&](const PlacedBody* body) {
    return dressing::misfitOf(cloth, body->mesh) == dressing::Misfit::None;
  });
  for (const dressing::Piercing& piercing : piercings) {
    const auto found =
        std::ranges::find_if(candidates, [&](const PlacedBody* body) { return body->body == piercing.body; });
    if (found != candidates.end()) {
      return *found;
    }
  }
  return candidates.empty() ? nullptr : candidates.front();
}

DressingOrder orderFor(const session::Snapshot& snapshot, std::size_t body) {
  DressingOrder order;
  const scene::SceneDescription& description = snapshot.scene->description;
  // A scene with a title has a key for a name, which says nothing about its cloth.
  order.names = {description.title.empty() ? text::Sentence::verbatim(description.name) : text::Sentence("the cloth"),
                 (*snapshot.scene->bodies)[body].name};
  order.model = snapshot.model;
  order.options.step = snapshot.settings.step;
  return order;
}

/// The meshes of one body among several.
const PlacedBody& placed(const std::vector<PlacedBody>& bodies, std::size_t body) {
  return *std::ranges::find(bodies, body, &PlacedBody::body);
}

bool isWhereItsFileHasIt(const scene::Scene& scene) {
  return std::ranges::all_of(scene.description.cloths,
                             [](const scene::ClothDescription& cloth) { return cloth.placement.isNone(); });
}

std::size_t sumOfPairs(const std::vector<dressing::Piercing>& piercings) {
  std::size_t sum = 0;
  for (const dressing::Piercing& piercing : piercings) {
    sum += piercing.pairs;
  }
  return sum;
}

}  // namespace

/// Dresses the body as it is now where it passes through the moving cloth: so the motion goes on. Else, or where that
/// fails, dresses the body at the start: from the place that the user gave the garment, or from one by landmarks.
void Viewer::dress(const session::Snapshot& snapshot) {
  if (dressing_ || sceneToDress_) {
    return;
  }
  stats_.error = {};
  ui::Placing& placing = controller_.placing();
  if (placing.isBuilding()) {
    dressesWhenBuilt_ = true;
    return;
  }
  const PiercingWatch::Found& found = piercings_.found();
  const std::vector<PlacedBody> now = bodiesOf(snapshot);
  const PlacedBody* body = bodyToDress(now, snapshot, found.piercings);
  if (body == nullptr) {
    showNotice("There is no body to dress. Drop the file of one on the window");
    return;
  }
  DressingOrder order = orderFor(snapshot, body->body);
  const sim::ClothMesh atStart = placed(dressing::bodiesAtStart(*snapshot.scene), body->body).mesh;
  const std::vector<Vec3>& start = snapshot.scene->start.positions;
  if (!found.piercings.empty() && !found.isStart && !placing.isOn()) {
    order.attempts.push_back({snapshot.positions, body->mesh, PlacementRule::File, false});
  }
  const bool isByHand = !isWhereItsFileHasIt(*snapshot.scene);
  if (!found.piercings.empty() || isByHand) {
    order.attempts.push_back({start, atStart, PlacementRule::File, true, isByHand});
  }
  // Several garments keep their places relative to each other, and so do those that a scene file has placed.
  const bool isOneGarment = snapshot.scene->cloths.size() == 1;
  if (isOneGarment || order.attempts.empty()) {
    order.attempts.push_back({start, atStart, isOneGarment ? PlacementRule::Auto : PlacementRule::File, true});
  }
  const bool isPaused = placing.isOn() ? !placing.wasPlaying() : snapshot.paused;
  ui::UiOutput ignored;  // the clock waits until the body is dressed
  placing.end(ignored);
  beginDressing(snapshot, std::move(order), isPaused);
}

/// Puts the garment where the body would wear it, and starts the mode Place there.
void Viewer::placeOnBody(const session::Snapshot& snapshot) {
  if (dressing_ || sceneToDress_ || controller_.placing().isBuilding()) {
    return;
  }
  stats_.error = {};
  const ui::Placing& placing = controller_.placing();
  DressingOrder order = orderToOpen(snapshot);
  if (order.attempts.empty()) {
    showNotice("There is no body to dress. Drop the file of one on the window");
    return;
  }
  order.attempts.front().rule = PlacementRule::Auto;
  order.options.move.setZero();
  order.options.turn = 0.0;
  order.onlyPlaces = true;
  beginDressing(snapshot, std::move(order), placing.isOn() ? !placing.wasPlaying() : snapshot.paused);
}

/// Dresses a scene that was opened for that, by the choices of the command line if there are any.
DressingOrder Viewer::orderToOpen(const session::Snapshot& snapshot) const {
  const std::vector<PlacedBody> bodies = dressing::bodiesAtStart(*snapshot.scene);
  const PlacedBody* body = bodyToDress(bodies, snapshot, {});
  DressingOrder order;
  if (body == nullptr) {
    return order;
  }
  order = orderFor(snapshot, body->body);
  PlacementRule rule = PlacementRule::Auto;
  if (dressingChoices_) {
    order.options = dressingChoices_->options(snapshot.settings);
    rule = order.options.rule;
  }
  order.attempts.push_back({snapshot.scene->start.positions, body->mesh, rule, true});
  return order;
}

void Viewer::beginDressing(const session::Snapshot& snapshot, DressingOrder order, bool isPaused) {
  wasPaused_ = isPaused;
  dressedScene_ = snapshot.scene;
  simulation_.post(session::PauseCommand{true});
  dressing_ = std::make_unique<DressingJob>(std::move(order));
}

void Viewer::followDressing(const session::Snapshot& snapshot) {
  piercings_.follow(snapshot, Clock::now());
  const std::vector<dressing::Piercing>& piercings = piercings_.found().piercings;
  stats_.piercing.reset();
  if (!piercings.empty()) {
    stats_.piercing = {inWords(piercings, *snapshot.scene), sumOfPairs(piercings)};
  }
  if (sceneToDress_ && snapshot.scene == sceneToDress_) {
    sceneToDress_.reset();
    DressingOrder order = orderToOpen(snapshot);
    order.onlyPlaces = snapshot.scene->description.parts.placed;
    if (!order.attempts.empty()) {
      beginDressing(snapshot, std::move(order), wasPaused_);
    }
  }
  if (dressesWhenBuilt_ && !controller_.placing().isBuilding()) {
    dressesWhenBuilt_ = false;
    dress(snapshot);
  }
  stats_.dressing.reset();
  if (!dressing_) {
    return;
  }
  if (snapshot.scene != dressedScene_) {
    dressing_.reset();  // another scene was opened meanwhile
    return;
  }
  lastChange_ = Clock::now();
  const DressingJob::Progress progress = dressing_->progress();
  stats_.dressing = {
      text::Sentence(dressing_->onlyPlaces() ? "Placing on {}: {}, {} %" : "Dressing {}: {}, {} %",
                     dressing_->names().body, inWords(progress.stage), static_cast<int>(100.0 * progress.share)),
      progress.share};
  if (const auto outcome = dressing_->poll()) {
    const bool onlyPlaced = dressing_->onlyPlaces();
    dressing_.reset();
    stats_.dressing.reset();
    endDressing(*outcome, onlyPlaced, snapshot);
  }
}

/// Shows the garment on the body, and lets the clock go on. A garment that cannot be worn stays where it is.
void Viewer::endDressing(const DressingJob::Outcome& outcome, bool onlyPlaced, const session::Snapshot& snapshot) {
  if (outcome.placed) {
    const std::vector<bool>& pinned = snapshot.model->pinned;
    if (std::ranges::find(pinned, true) != pinned.end()) {
      simulation_.post(session::SetPinsCommand{});  // pins give way to the body
    }
    simulation_.post(*outcome.placed);
  }
  outcome.hasFailed ? showError(outcome.message) : showNotice(outcome.message);
  if (onlyPlaced) {
    placeGarment(outcome.pose, snapshot);
  } else {
    simulation_.post(session::PauseCommand{wasPaused_});
  }
}

/// Moves the cloths by a pose if there is one, and lets the user move, turn and scale it.
void Viewer::placeGarment(const std::optional<sim::contact::Pose>& pose, const session::Snapshot& snapshot) {
  ui::Placing& placing = controller_.placing();
  if (!placing.isOn()) {
    ui::UiOutput output;
    controller_.startPlacing(!wasPaused_, output);
    execute(output, snapshot);
  }
  scene::Placements placements = placing.placements(snapshot);
  if (pose) {
    for (scene::Placement& cloth : placements.cloths) {
      const Vec3 origin = cloth.position;
      cloth =
          scene::movedTo(scene::turnedAbout(cloth, Vec3::Zero(), pose->rotation), Vec3::Zero(), pose->toWorld(origin));
    }
  }
  if (placements != placing.placements(snapshot)) {
    on(ui::RebuildSceneRequest{snapshot.settings, std::move(placements)}, snapshot);
  }
}

void Viewer::cancelDressing() {
  if (dressing_) {
    dressing_->cancel();
  }
}

}  // namespace drape::app
