#include "app/dressing/piercing_watch.hpp"

#include "session/take_if_ready.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace drape::app {
namespace {

constexpr auto interval = std::chrono::seconds(2);

/// Whether contact could not keep the cloth outside the bodies.
bool hasTrouble(const session::Snapshot& snapshot) {
  const sim::contact::ContactReport& contact = snapshot.stepReport.contact;
  return contact.overlaps > 0 || contact.infeasible > 0;
}

bool isOn(const session::Snapshot& snapshot, std::size_t body) {
  return body < snapshot.bodies.size() && snapshot.bodies[body].on;
}

}  // namespace

std::vector<dressing::PlacedBody> bodiesOf(const session::Snapshot& snapshot) {
  const std::vector<sim::contact::Body>& bodies = *snapshot.scene->bodies;
  std::vector<dressing::PlacedBody> placed;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (isOn(snapshot, i) && !std::holds_alternative<sim::contact::PlaneShape>(bodies[i].shape)) {
      const session::BodyStatus& status = snapshot.bodies[i];
      placed.push_back({i, dressing::placedBody(bodies[i], status.pose, status.vertices)});
    }
  }
  return placed;
}

void PiercingWatch::follow(const session::Snapshot& snapshot, Clock::time_point now) {
  take(now);
  if (snapshot.scene != scene_ || snapshot.placedStart != placedStart_) {
    if (snapshot.scene != scene_) {
      search_ = std::make_shared<dressing::PiercingSearch>(snapshot.scene);
    }
    scene_ = snapshot.scene;
    placedStart_ = snapshot.placedStart;
    found_ = {};
    knowsStart_ = false;
    isStale_ = running_.valid();
  }
  if (running_.valid()) {
    return;
  }
  if (!snapshot.settings.step.contact.bodies) {
    found_ = {};
    knowsStart_ = true;
  } else if (!knowsStart_) {
    std::vector<dressing::PlacedBody> bodies = dressing::bodiesAtStart(*scene_);
    std::erase_if(bodies, [&](const dressing::PlacedBody& each) { return !isOn(snapshot, each.body); });
    version_ = snapshot.version;
    begin(placedStart_ ? *placedStart_ : scene_->start.positions, std::move(bodies), true);
  } else if (now >= nextLook_ && snapshot.version != version_ && (hasTrouble(snapshot) || !found_.piercings.empty())) {
    version_ = snapshot.version;
    begin(snapshot.positions, bodiesOf(snapshot), false);
  }
}

void PiercingWatch::take(Clock::time_point now) {
  std::optional<Found> found = session::takeIfReady(running_);
  if (found && !std::exchange(isStale_, false)) {
    knowsStart_ = true;
    found_ = *std::move(found);
    nextLook_ = now + interval;
  }
}

void PiercingWatch::begin(std::vector<Vec3> positions, std::vector<dressing::PlacedBody> bodies, bool isStart) {
  running_ =
      std::async(std::launch::async,
                 [search = search_, positions = std::move(positions), bodies = std::move(bodies), isStart]() -> Found {
                   try {
                     return {search->find(positions, bodies), isStart};
                   } catch (const std::exception&) {
                     return {{}, isStart};  // the cloth is not finite; the simulation reports that
                   }
                 });
}

}  // namespace drape::app
