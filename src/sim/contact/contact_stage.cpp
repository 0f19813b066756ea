#include "sim/contact/contact_stage.hpp"

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/closest_features/mesh_in_step.hpp"
#include "sim/contact/exact/exact_self_contact.hpp"
#include "sim/contact/inverse_mass.hpp"
#include "sim/contact/self/memory.hpp"
#include "sim/contact/self/self_contact.hpp"
#include "sim/contact/solve/body_contact.hpp"
#include "sim/contact/solve/remove_approach.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/bounds.hpp"
#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace drape::sim::contact {

namespace {

constexpr int maxGuardRounds = 8;  // in which cloth is kept apart from itself, and then out of bodies

/// Whether all coordinates are small enough for a search. In a simulation that diverges, squares of coordinates would
/// overflow.
bool hasBoundedPositions(const std::vector<Vec3>& positions) {
  constexpr double maxCoordinate = 1e8;  // [m]
  return areWithin(positions, maxCoordinate);
}

/// Whether free vertices move so far relative to each other that only a solver that diverges can be the cause. The
/// search for pairs would then find nearly all pairs of the cloth. Without contact the positions soon are no longer
/// finite, which is reported.
bool diverges(const ClothModel& model, const std::vector<Vec3>& start, const std::vector<Vec3>& end, double timeStep) {
  constexpr double diagonals = 2.0;   // of the cloth [-]
  constexpr double maxSpeed = 300.0;  // of a small cloth [m/s]
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (!model.pinned[v]) {
      sum += end[v] - start[v];
      ++count;
    }
  }
  const Vec3 mean = sum / std::max(1, count);
  const double allowed = std::max(diagonals * boundsOf(start).diagonal().norm(), maxSpeed * timeStep);
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (!model.pinned[v] && (end[v] - start[v] - mean).squaredNorm() > allowed * allowed) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool meetsBodies(const ContactParameters& contact, const StepInputs& inputs) {
  return contact.bodies && inputs.bodies != nullptr && !inputs.bodies->empty();
}

ContactStage::ContactStage() = default;
ContactStage::ContactStage(ContactStage&&) noexcept = default;
ContactStage& ContactStage::operator=(ContactStage&&) noexcept = default;
ContactStage::~ContactStage() = default;

void ContactStage::begin(const ContactParameters& contact, const StepInputs& inputs, const ClothState& state) {
  active_ = contact.self != SelfCollision::Off || meetsBodies(contact, inputs);
  changed_ = false;
  bodySeconds_ = 0.0;
  selfSeconds_ = std::exchange(selfSecondsBefore_, 0.0);
  if (active_) {
    start_ = state.positions;
    startIsBounded_ = hasBoundedPositions(start_);
  }
}

bool ContactStage::isNearBodies(const ClothModel& model, const CommonParameters& parameters,
                                const ContactParameters& contact, const StepInputs& inputs, const ClothState& state) {
  const double fall = parameters.gravity * parameters.timeStep * parameters.timeStep;
  extrapolate(state, parameters.timeStep);
  return hasBoundedPositions(state.positions) &&
         bodyContact().isNearAnyBody(model, contact, *inputs.bodies, state.positions, ahead_, fall);
}

SelfApproach ContactStage::approachOfItself(const ClothModel& model, const CommonParameters& parameters,
                                            const ContactParameters& contact, const ClothState& state) {
  if (contact.self == SelfCollision::Exact && hasBoundedPositions(state.positions)) {
    const auto begin = std::chrono::steady_clock::now();
    extrapolate(state, parameters.timeStep);
    const SelfApproach approach = exactSelfContact().approach(
        {model, parameters, contact, state.positions, state.hasNoSelfIntersection, state.selfContact}, ahead_);
    selfSecondsBefore_ += secondsSince(begin);
    return approach;
  }
  const bool hasPairs = state.selfContact == nullptr || state.selfContact->pairs.count() > 0;
  return {.isNear = contact.self == SelfCollision::Hash && hasPairs, .motion = 0.0};
}

void ContactStage::extrapolate(const ClothState& state, double timeStep) {
  ahead_.resize(state.positions.size());
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    ahead_[v] = state.positions[v] + timeStep * state.velocities[v];
  }
}

BodyContact& ContactStage::bodyContact() {
  if (!bodies_) {
    bodies_ = std::make_unique<BodyContact>();
  }
  return *bodies_;
}

void ContactStage::findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                                       const ContactParameters& contact, const StepInputs& inputs, ClothState& state,
                                       std::vector<SubstepContact>& found) {
  const bool acts = contact.self != SelfCollision::Off || meetsBodies(contact, inputs);
  if (!acts || !hasBoundedPositions(state.positions)) {
    return;
  }
  extrapolate(state, parameters.timeStep);
  if (contact.self == SelfCollision::Hash) {
    const auto begin = std::chrono::steady_clock::now();
    selfContact().findSubstepContacts(model, parameters, contact, ahead_, state, found);
    selfSeconds_ += secondsSince(begin);
  }
  if (contact.self == SelfCollision::Exact) {
    const auto begin = std::chrono::steady_clock::now();
    exactSelfContact().findSubstepContacts(
        {model, parameters, contact, state.positions, state.hasNoSelfIntersection, state.selfContact}, ahead_, found);
    selfSeconds_ += secondsSince(begin);
  }
  if (meetsBodies(contact, inputs)) {
    const auto begin = std::chrono::steady_clock::now();
    bodyContact().findSubstepContacts(model, parameters, contact, *inputs.bodies, state.positions, ahead_, found);
    bodySeconds_ += secondsSince(begin);
  }
}

bool ContactStage::addMissedContacts(const ClothModel& model, const CommonParameters& parameters,
                                     const ContactParameters& contact, const ClothState& state,
                                     std::vector<SubstepContact>& listed) {
  if (contact.self != SelfCollision::Exact || !startIsBounded_ || !hasBoundedPositions(state.positions)) {
    return false;
  }
  const auto begin = std::chrono::steady_clock::now();
  const bool added = exactSelfContact().addMissedContacts(
      {model, parameters, contact, start_, state.hasNoSelfIntersection, state.selfContact}, state.positions, listed);
  selfSeconds_ += secondsSince(begin);
  return added;
}

SelfContact& ContactStage::selfContact() {
  if (!self_) {
    self_ = std::make_unique<SelfContact>();
  }
  return *self_;
}

ExactSelfContact& ContactStage::exactSelfContact() {
  if (!exact_) {
    exact_ = std::make_unique<ExactSelfContact>();
  }
  return *exact_;
}

/// Keeps the cloth from passing through itself. Where this moves the cloth into bodies, planes move it out, and the
/// cloth is guarded again.
void ContactStage::guardAgainstItself(const ExactStep& step, const std::vector<BodyStep>* bodies, ClothState& state,
                                      ContactReport& report) {
  if (bodies == nullptr) {
    report.crossings = exactSelfContact().guard(step, {}, state).value_or(0);
    return;
  }
  planes_.clear();
  setFallback(state);
  for (int round = 0; round < maxGuardRounds; ++round) {
    unguarded_ = state.positions;
    report.crossings = guardOnce(step, round == 0, state);
    if (state.positions == unguarded_) {
      return;
    }
    unguarded_ = state.positions;
    if (!bodyContact().keepOut(step.model, step.parameters, step.contact, *bodies,
                               allAreCarried_ ? fallback_ : resolved_, state.positions)) {
      return;
    }
    const auto bodyVelocity = [&](std::size_t v) {
      return Vec3((fallback_[v] - start_[v]) / step.parameters.timeStep);
    };
    removeApproach(unguarded_, bodyVelocity, std::nullopt, state);
  }
  // No positions were found that satisfy both. The cloth stops for this step.
  const std::vector<double> inverseMass = inverseMassOf(step.model);
  for (std::size_t v = 0; v < fallback_.size(); ++v) {
    if (inverseMass[v] > 0.0) {
      state.positions[v] = fallback_[v];
      state.velocities[v] = (fallback_[v] - start_[v]) / step.parameters.timeStep;
    }
  }
  report.crossings = exactSelfContact().guard(step, {planes_, fallback_}, state).value_or(0);
}

/// One round of the guard. Only a round that must move cloth needs complete planes.
/// @returns number of pairs that could not be separated
int ContactStage::guardOnce(const ExactStep& step, bool isFirst, ClothState& state) {
  const auto kept = static_cast<std::ptrdiff_t>(planes_.size());
  setPlanesAfter(kept);
  if (const auto crossings = exactSelfContact().guard(step, {planes_, fallback_, false}, state)) {
    return *crossings;
  }
  bodyContact().completePlanes(step.model, step.parameters, step.contact, start_);
  setPlanesAfter(kept);
  if (isFirst) {
    setFallback(state);  // depends on the planes
  }
  return exactSelfContact().guard(step, {planes_, fallback_}, state).value_or(0);
}

/// Replaces all planes but the first `kept` ones by the present planes of bodies. Those of earlier rounds are kept, so
/// that the rounds converge.
void ContactStage::setPlanesAfter(std::ptrdiff_t kept) {
  const std::span<const SeparatingPlane> present = bodyContact().planes();
  planes_.erase(planes_.begin() + kept, planes_.end());
  planes_.insert(planes_.end(), present.begin(), present.end());
}

/// Sets the positions to which the guard can move vertices back, and those outside all bodies from which keepOut
/// searches.
void ContactStage::setFallback(const ClothState& state) {
  fallback_ = start_;
  allAreCarried_ = bodyContact().carryAlong(fallback_);
  resolved_ = state.positions;
}

ContactReport ContactStage::keepLast() {
  changed_ = false;
  report_.bodySeconds = report_.selfSeconds = report_.guardWork = 0.0;
  return report_;
}

ContactReport ContactStage::resolve(const ClothModel& model, const CommonParameters& parameters,
                                    const ContactParameters& contact, const StepInputs& inputs, ClothState& state,
                                    double stepFraction) {
  points_.clear();
  report_ = correct(model, parameters, contact, inputs, state, stepFraction);
  return report_;
}

/// `resolve` without storing the report.
ContactReport ContactStage::correct(const ClothModel& model, const CommonParameters& parameters,
                                    const ContactParameters& contact, const StepInputs& inputs, ClothState& state,
                                    double stepFraction) {
  ContactReport report{.bodySeconds = bodySeconds_, .selfSeconds = selfSeconds_};
  // Only exact self-collision prevents intersections, and sets this again.
  const bool hadNoIntersection = std::exchange(state.hasNoSelfIntersection, false);
  if (!active_ || !startIsBounded_ || !hasBoundedPositions(state.positions)) {
    return report;
  }
  if (contact.self == SelfCollision::Exact && diverges(model, start_, state.positions, parameters.timeStep)) {
    return report;
  }
  // Far from all bodies, contact costs no more than two bounding boxes.
  const bool nearBodies =
      meetsBodies(contact, inputs) &&
      bodyContact().couldReachAnyBody(contact, *inputs.bodies, boundsOf(start_), boundsOf(state.positions));
  if (contact.self == SelfCollision::Off && !nearBodies) {
    return report;
  }
  unresolved_.positions = state.positions;
  unresolved_.velocities = state.velocities;
  // Self-collision runs before body contact, so that it cannot push cloth into a body.
  if (contact.self == SelfCollision::Hash) {
    const auto begin = std::chrono::steady_clock::now();
    report.selfContacts =
        selfContact().resolve(model, contact, parameters.timeStep, start_, state, points_, stepFraction);
    report.selfSeconds += secondsSince(begin);
  }
  if (contact.self == SelfCollision::Exact) {
    const auto begin = std::chrono::steady_clock::now();
    report.selfContacts = exactSelfContact().resolve(
        {model, parameters, contact, start_, hadNoIntersection, state.selfContact}, state, points_);
    report.intersections = exactSelfContact().intersectionsAtStart();
    report.selfSeconds += secondsSince(begin);
  }
  if (meetsBodies(contact, inputs)) {
    const auto before = std::chrono::steady_clock::now();
    bodyContact().resolve(model, parameters, contact, *inputs.bodies, start_, state, report, points_);
    if (inputs.contacts != nullptr) {
      bodyContact().reportSubstepContacts(*inputs.contacts, state, report, points_);
    }
    report.bodySeconds += secondsSince(before);
  }
  if (contact.self == SelfCollision::Exact) {
    const auto begin = std::chrono::steady_clock::now();
    beforeGuard_.positions = state.positions;
    beforeGuard_.velocities = state.velocities;
    guardAgainstItself({model, parameters, contact, start_, hadNoIntersection, state.selfContact},
                       nearBodies ? inputs.bodies : nullptr, state, report);
    // Of cloth that intersects itself the energy is not removed: recovery moves crossing parts against the springs.
    if (report.intersections == 0 && state.positions != beforeGuard_.positions) {
      report.guardWork = energyOf(model, parameters, state).total() - energyOf(model, parameters, beforeGuard_).total();
    }
    report.selfSeconds += secondsSince(begin);
  }
  // Contact of the cloth with itself alone conserves momentum.
  if (contact.self == SelfCollision::Exact && nearBodies && inputs.contacts == nullptr) {
    limitApproach(unresolved_.positions, start_, parameters.timeStep, state);
  }
  changed_ = report.selfContacts > 0 || report.bodyContacts > 0;
  if (changed_) {
    state.history.timeStep = 0.0;  // a multistep method must not continue the motion that contact stopped
  }
  return report;
}

}  // namespace drape::sim::contact
