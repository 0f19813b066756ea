#include "session/open_seams.hpp"
#include "session/simulation.hpp"

namespace drape::session {

void Simulation::capture(Snapshot& snapshot) const {
  snapshot.scene = scene_;
  snapshot.model = cloth_.pieces();
  snapshot.positions = state_.positions;
  snapshot.placedStart = placedStart_;
  snapshot.pinPaths = pinPaths_;
  snapshot.sewing = sewing_;
  snapshot.seams = cloth_.seams();
  snapshot.isWelded = cloth_.isWelded();
  snapshot.step = stepIndex_;
  snapshot.version = version_;
  snapshot.pictureVersion = pictureVersion_;
  snapshot.time = state_.time;
  snapshot.settings = settings_;
  snapshot.paused = paused_;
  snapshot.energy = sim::energyOf(*model_, settings_.step, state_);
  snapshot.balance = balance_;
  snapshot.accuracy = accuracy();
  snapshot.maxStretch = sim::maxStretch(*model_, state_);
  snapshot.stepSeconds = stepSeconds_;
  snapshot.stepReport = stepReport_;
  snapshot.message = message();
  if (snapshot.message.empty()) {
    snapshot.message = lateSeamsInWords(cloth_.openSeams(), state_);
  }
  const bool isSewn = cloth_.hasSeams() && cloth_.openSeams().empty();
  if (snapshot.message.empty() && isSewn && snapshot.maxStretch > sim::tooTight) {
    snapshot.message = tightSewingInWords(*model_, state_);
  }
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

}  // namespace drape::session
