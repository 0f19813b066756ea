#include "sim/contact/solve/body_contact.hpp"

#include "sim/contact/constraints/contact_search.hpp"
#include "sim/contact/solve/convergence.hpp"
#include "sim/contact/solve/remove_approach.hpp"
#include "sim/contact/solve/substep_contacts.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr int maxPasses = 4;

bool isStill(const NearBody& body) {
  const Pose& start = body.step->start;
  const Pose& end = body.step->end;
  return start.position == end.position && start.rotation == end.rotation;
}

/// A position that moves rigidly with a body in a step [m].
Vec3 carriedBy(const NearBody& body, const Vec3& position) {
  return body.step->end.toWorld(body.step->start.toLocal(position));
}

/// Whether two bodies move by the same rigid motion in a step.
bool moveAlike(const NearBody& a, const NearBody& b) {
  const auto isRigid = [](const NearBody& body) { return body.mesh == nullptr || !body.mesh->isDeforming(); };
  return isRigid(a) && isRigid(b) && (a.index == b.index || (isStill(a) && isStill(b)));
}

}  // namespace

const PreparedCloth& BodyContact::prepared(const ClothModel& model) {
  return prepared_.get(model, [this](const ClothModel& m) { return PreparedCloth(m, ++models_); });
}

/// @return true if the cloth could reach bodies that were not known
bool BodyContact::addReachableBodies(const ClothStep& step, const std::vector<BodyStep>& bodies,
                                     const std::vector<Vec3>& positions, const Eigen::AlignedBox3d& ends) {
  const std::vector<ReachableBody> found =
      reachable_.find(step, prepared(step.model), bodies, positions, ends, bodies_.steps());
  bodies_.add(found, step);
  return !found.empty();
}

void BodyContact::resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                          const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
                          ContactReport& report, std::vector<ContactPoint>& points) {
  const ClothStep step{model, parameters, contact, start, predicted_};
  predicted_ = state.positions;
  bodies_.clear();
  overlaps_.clear();
  planes_.clear();
  Eigen::AlignedBox3d ends = boundsOf(predicted_);
  while (addReachableBodies(step, bodies, state.positions, ends)) {
    runPasses(step, report, state.positions);
    ends.extend(boundsOf(state.positions));  // contact can move the cloth near other bodies
  }
  if (bodies_.empty()) {
    return;
  }
  response_.solveVelocities(step, prepared(model), candidates_.contacts, state.positions, state.velocities);
  removeApproachToPlanes(step, state);
  overlaps_.limitVelocities(parameters.timeStep, state);
  report.bodyContacts = static_cast<int>(response_.active().size());
  for (const ContactConstraint& each : response_.active()) {
    points.push_back({pointOf(each, state.positions), each.normal});
  }
}

/// Removes the velocity of vertices towards the planes that moved them. Otherwise vertices without a contact would keep
/// this velocity, and stretch the cloth more in each step.
void BodyContact::removeApproachToPlanes(const ClothStep& step, ClothState& state) const {
  std::vector<Vec3> velocities(state.positions.size(), Vec3::Zero());
  for (const SeparatingPlane& plane : planes()) {
    const Vec3& start = step.start[plane.vertex];
    velocities[plane.vertex] = (carriedBy(bodies_[plane.body], start) - start) / step.parameters.timeStep;
  }
  removeApproach(
      planes_.unprojected(), [&](std::size_t v) { return velocities[v]; }, step.parameters.timeStep, state);
}

void BodyContact::runPasses(const ClothStep& step, ContactReport& report, std::vector<Vec3>& positions) {
  report.infeasible = 0;
  const PreparedCloth& cloth = prepared(step.model);
  bool again = runPass({step, cloth, bodies_, nullptr, workers_}, report, positions);
  for (int i = 1; i < maxPasses && again; ++i) {
    const std::vector<Vec3> previous = positions;
    again = runPass({step, cloth, bodies_, &previous, workers_}, report, positions);
  }
}

/// One search and one correction. Returns true if another pass is needed.
bool BodyContact::runPass(const ContactPass& pass, ContactReport& report, std::vector<Vec3>& positions) {
  lastPassStartsAtEnd_ = pass.atEnd();
  bodies_.beginPass(pass.cloth);
  bool newlyFound = true;
  for (int i = 0; i < 2 && newlyFound; ++i) {
    frames_.prepare(pass);
    overlaps_.find(pass, frames_, i == 0);
    if (overlaps_.any() && !pass.atEnd()) {
      overlaps_.limitDisplacements(pass, frames_, predicted_);
      frames_.prepare(pass);
    }
    overlaps_.extendBounds(pass, frames_);
    newlyFound = findAndSolveContacts(pass, positions);
    if (bodies_.haveMeshes()) {
      frames_.tightenBounds(bodies_);
      newlyFound = planes_.find(pass, frames_, overlaps_) || newlyFound;
    }
  }
  if (!pass.atEnd()) {
    report.overlaps = candidates_.overlaps;
    report.deepestOverlap = candidates_.deepestOverlap;
  }
  report.infeasible = std::max(report.infeasible, planes_.apply(pass, frames_, overlaps_, positions));
  return needsAnotherPass(pass, candidates_.contacts, overlaps_, planes_.maxCorrection(), positions);
}

/// Finds the contacts of a pass, and solves for positions that satisfy them.
/// @return true if cloth was found inside a sphere or capsule, so that the search must be repeated
bool BodyContact::findAndSolveContacts(const ContactPass& pass, std::vector<Vec3>& positions) {
  VertexContacts found = findVertexContacts(pass, frames_, overlaps_);
  candidates_ = std::move(found.candidates);
  planes_.begin(std::exchange(candidates_.planes, {}));
  response_.solvePositions(pass, candidates_.contacts, positions);
  if (bodies_.haveMeshes()) {
    frames_.setSolved(pass, positions);
    const std::vector<ContactConstraint> sharp = findSharpFeatureContacts(pass, frames_, overlaps_);
    if (!sharp.empty()) {
      candidates_.contacts.insert(candidates_.contacts.end(), sharp.begin(), sharp.end());
      response_.solvePositions(pass, candidates_.contacts, positions);
      frames_.setSolved(pass, positions);
    }
  }
  return overlaps_.findInPrimitives(pass, frames_, found.entered);
}

bool BodyContact::keepOut(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                          const std::vector<BodyStep>& bodies, const std::vector<Vec3>& outside,
                          std::vector<Vec3>& positions) {
  predicted_ = positions;
  const ClothStep step{model, parameters, contact, outside, predicted_};
  addReachableBodies(step, bodies, positions, boundsOf(positions));
  if (bodies_.empty()) {
    return false;
  }
  const ContactPass pass{step, prepared(model), bodies_, &outside, workers_};
  lastPassStartsAtEnd_ = pass.atEnd();
  bodies_.beginPass(pass.cloth);
  frames_.prepare(pass);
  overlaps_.find(pass, frames_, true);
  overlaps_.extendBounds(pass, frames_);
  planes_.begin(findVertexContacts(pass, frames_, overlaps_).candidates.planes);
  if (bodies_.haveMeshes()) {
    frames_.setSolved(pass, positions);
    frames_.tightenBounds(bodies_);
    planes_.find(pass, frames_, overlaps_);
  }
  planes_.apply(pass, frames_, overlaps_, positions);
  if (planes_.maxCorrection() > planeTolerance) {
    return true;
  }
  positions = predicted_;
  return false;
}

void BodyContact::completePlanes(const ClothModel& model, const CommonParameters& parameters,
                                 const ContactParameters& contact, const std::vector<Vec3>& start) {
  if (bodies_.haveMeshes()) {
    const ClothStep step{model, parameters, contact, start, predicted_};
    planes_.complete({step, prepared(model), bodies_, lastPassStartsAtEnd_ ? &start : nullptr, workers_}, frames_,
                     overlaps_);
  }
}

void BodyContact::findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                                      const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                      const std::vector<Vec3>& start, const std::vector<Vec3>& ahead,
                                      std::vector<SubstepContact>& found) {
  const ClothStep step{model, parameters, contact, start, ahead};
  const double fall = parameters.gravity * parameters.timeStep * parameters.timeStep;
  bodies_.clear();
  overlaps_.clear();
  if (!addReachableBodies(step, bodies, ahead, inflated(boundsOf(ahead), fall))) {
    return;
  }
  for (NearBody& body : bodies_) {
    body.offsets.separationStep = 0.0;
    body.offsets.listMargin = listMarginOf(body.offsets.contactOffset, fall);
  }
  const ContactPass pass{step, prepared(model), bodies_, nullptr, workers_};
  bodies_.beginPass(pass.cloth);
  frames_.prepare(pass);
  frames_.extendBounds(listMarginOf(bodies_.maxContactOffset(), fall));
  std::vector<ContactConstraint> contacts = findVertexContacts(pass, frames_, overlaps_).candidates.contacts;
  if (bodies_.haveMeshes()) {
    frames_.setSolved(pass, ahead);
    const std::vector<ContactConstraint> sharp = findSharpFeatureContacts(pass, frames_, overlaps_);
    contacts.insert(contacts.end(), sharp.begin(), sharp.end());
  }
  for (const ContactConstraint& each : contacts) {
    if (const auto listed = substepContactOf(each, bodies_[each.body], parameters.timeStep)) {
      found.push_back(*listed);
    }
  }
}

void BodyContact::reportSubstepContacts(const std::vector<SubstepContact>& contacts, const ClothState& state,
                                        ContactReport& report, std::vector<ContactPoint>& points) const {
  contact::reportSubstepContacts(response_.active(), contacts, state, report, points);
}

bool BodyContact::carryAlong(std::vector<Vec3>& positions) const {
  const auto carry = [&](int body, Vec3& position) { position = carriedBy(bodies_[body], position); };
  const std::span<const SeparatingPlane> all = planes();
  if (!all.empty() && std::all_of(all.begin(), all.end(), [&](const SeparatingPlane& each) {
        return moveAlike(bodies_[each.body], bodies_[all[0].body]);
      })) {
    for (Vec3& position : positions) {
      carry(all[0].body, position);
    }
    return true;
  }
  std::vector<bool> carried(positions.size(), false);
  for (const SeparatingPlane& plane : all) {
    if (!carried[plane.vertex]) {
      carried[plane.vertex] = true;
      carry(plane.body, positions[plane.vertex]);
    }
  }
  return false;
}

bool BodyContact::couldReachAnyBody(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                    const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end) {
  return reachable_.couldReachAny(contact, bodies, start, end);
}

bool BodyContact::isNearAnyBody(const ClothModel& model, const ContactParameters& contact,
                                const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                const std::vector<Vec3>& end, double spread) {
  return reachable_.isNearAny(model, prepared(model), contact, bodies, start, end, spread);
}

}  // namespace drape::sim::contact
