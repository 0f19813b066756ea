#include "sim/contact/exact/exact_self_contact.hpp"

#include "sim/contact/exact/corrections.hpp"
#include "sim/contact/exact/crossing_recovery.hpp"
#include "sim/contact/solve/remove_approach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace drape::sim::contact {
namespace {

// In thicknesses:
constexpr double contactMargin = 0.25;  // pairs whose predicted distance exceeds the thickness by less are contacts
constexpr double substepMargin = 0.05;  // the same for substep contacts, in addition to the fall by gravity
constexpr double missedDepth = 0.25;    // the substeps are repeated with a contact that was violated by more
constexpr double activeGap = 0.1;       // velocities are corrected up to this excess over the required distance
constexpr double recoveryMargin = 0.1;  // distance at which crossing features count as separate

constexpr double separationSpeed = 0.05;  // at which layers that are too close move apart [m/s]
constexpr int impulseIterations = 10;

/// If patches become invalid in more rounds of the guard, all pairs are checked.
constexpr int maxPatchRounds = 3;

/// Whether so many parts of a strained cloth cross each other that no data tell which side is wrong, as in cloth with
/// noise in its positions. Springs then smooth the cloth within a few steps. Moving crossing parts apart would keep it
/// crumpled.
bool isCrumpled(const ClothModel& model, std::size_t crossings, std::span<const Vec3> positions) {
  constexpr double crossingsPerTriangle = 0.5;
  constexpr double meanStrain = 0.2;
  if (static_cast<double>(crossings) < crossingsPerTriangle * static_cast<double>(model.triangles.size())) {
    return false;
  }
  double sum = 0.0;
  for (const Spring& spring : model.springs) {
    sum += std::abs((positions[spring.b] - positions[spring.a]).norm() / spring.restLength - 1.0);
  }
  return sum > meanStrain * static_cast<double>(model.springs.size());
}

/// The distance up to which pairs are searched [m].
double reachOf(const ExactStep& step) {
  return approachSlack * (1.0 + contactMargin) * step.contact.thickness;
}

/// The coordinate of a contact along its normal [m].
double alongNormal(const SubstepContact& contact, const std::vector<Vec3>& positions) {
  Vec3 offset = Vec3::Zero();
  for (std::size_t k = 0; k < contact.vertices.size(); ++k) {
    offset += contact.weights[k] * positions[contact.vertices[k]];
  }
  return contact.normal.dot(offset);
}

}  // namespace

const std::vector<double>& ExactSelfContact::inverseMass(const ClothModel& model) {
  return inverseMass_.get(model, inverseMassOf);
}

void ExactSelfContact::findContacts(const ExactStep& step, double margin, double separationStep,
                                    const std::vector<Vec3>& predicted, std::vector<SubstepContact>& found) {
  const double thickness = step.contact.thickness;
  const int threads = step.parameters.threads;
  findEntangledAt(step);
  search_.update({step.model, reachOf(step), reachOf(step), patchesAtStart(step), threads}, step.start, predicted,
                 workers_);
  findPairContacts(step.model, search_,
                   {.thickness = thickness,
                    .margin = std::min(margin, contactMargin * thickness),
                    .separationStep = separationStep,
                    .staticFriction = step.contact.staticFriction,
                    .kineticFriction = step.contact.kineticFriction,
                    .entangled = entangled_},
                   step.start, predicted, workers_, threads, found);
}

/// The patches that the last step stored, or new ones.
SharedFeaturePatches ExactSelfContact::patchesAtStart(const ExactStep& step) {
  const FeatureMesh& mesh = search_.meshOf(step.model);
  const bool known = step.memory != nullptr && step.memory->vertices == step.model.vertexCount() &&
                     step.memory->triangles == static_cast<int>(step.model.triangles.size()) &&
                     step.memory->patches.acrossBorders[0] != nullptr;  // null after a step with the hash
  return patches_.ofFeatures(mesh,
                             known ? step.memory->patches : patches_.update(step.model, reachOf(step), step.start, {}));
}

/// Finds the vertices of triangles that intersect at the start of the step.
void ExactSelfContact::findEntangledAt(const ExactStep& step) {
  crossings_.clear();
  if (!step.hasNoSelfIntersection) {
    crossings_ = search_.crossingsAt(step.model, step.start);
  }
  markEntangled(search_.meshOf(step.model), crossings_, step.start.size(), entangled_);
}

/// Finds the contacts of the whole step for these predicted positions, unless they are known already.
void ExactSelfContact::findContactsAtEnd(const ExactStep& step, const std::vector<Vec3>& predicted) {
  if (predicted_ != predicted) {
    contacts_.clear();
    findContacts(step, contactMargin * step.contact.thickness, separationSpeed * step.parameters.timeStep, predicted,
                 contacts_);
    predicted_ = predicted;
  }
}

SelfApproach ExactSelfContact::approach(const ExactStep& step, const std::vector<Vec3>& ahead) {
  contacts_.clear();
  predicted_.clear();
  findContacts(step, contactMargin * step.contact.thickness, 0.0, ahead, contacts_);
  SelfApproach approach{.isNear = !contacts_.empty(), .motion = 0.0};
  for (const SubstepContact& contact : contacts_) {
    Vec3 motion = Vec3::Zero();
    for (std::size_t k = 0; k < contact.vertices.size(); ++k) {
      motion += contact.weights[k] * (ahead[contact.vertices[k]] - step.start[contact.vertices[k]]);
    }
    approach.motion = std::max(approach.motion, motion.norm());
  }
  return approach;
}

void ExactSelfContact::findSubstepContacts(const ExactStep& step, const std::vector<Vec3>& ahead,
                                           std::vector<SubstepContact>& found) {
  const double h = step.parameters.timeStep;
  predicted_.clear();
  findContacts(step, substepMargin * step.contact.thickness + step.parameters.gravity * h * h, 0.0, ahead, found);
}

bool ExactSelfContact::addMissedContacts(const ExactStep& step, const std::vector<Vec3>& predicted,
                                         std::vector<SubstepContact>& listed) {
  findContactsAtEnd(step, predicted);
  const double allowed = missedDepth * step.contact.thickness;
  std::vector<SubstepContact> violated;
  for (const SubstepContact& contact : contacts_) {
    // Substep contacts do not move apart features that are too close at the start.
    const double height = std::min(contact.height, alongNormal(contact, step.start));
    if (height - alongNormal(contact, predicted) > allowed) {
      violated.push_back(contact);
      violated.back().height = height;
    }
  }
  if (violated.empty()) {
    return false;
  }
  std::set<std::array<int, 4>> known;
  for (const SubstepContact& contact : listed) {
    known.insert(contact.vertices);
  }
  std::erase_if(violated, [&](const SubstepContact& contact) { return known.contains(contact.vertices); });
  listed.insert(listed.end(), violated.begin(), violated.end());
  return !violated.empty();
}

void ExactSelfContact::solvePositions(const ExactStep& step, ClothState& state) {
  constraints_.clear();
  goals_.clear();
  for (const SubstepContact& contact : contacts_) {
    ContactConstraint constraint;
    constraint.vertices = contact.vertices;
    constraint.weights = contact.weights;
    constraint.normal = contact.normal;
    constraint.offset = contact.height;
    constraint.staticFriction = contact.staticFriction;
    constraint.kineticFriction = contact.kineticFriction;
    goals_.push_back({contact.height, pointOf(constraint, step.start)});
    constraints_.push_back(constraint);
  }
  before_ = state.positions;
  solver_.solve(constraints_, goals_, inverseMass(step.model), impulseIterations, state.positions);
  if (pinSpeed_ > 0.0) {
    limitCorrections(largestCorrection(step.start, before_, step.contact.thickness), before_, state.positions);
  }
}

/// The speed of the fastest pin in the step [m/s].
double ExactSelfContact::pinSpeedOf(const ExactStep& step, std::span<const Vec3> end) {
  double squared = 0.0;
  for (std::size_t v = 0; v < end.size(); ++v) {
    if (step.model.pinned[v]) {
      squared = std::max(squared, (end[v] - step.start[v]).squaredNorm());
    }
  }
  return std::sqrt(squared) / step.parameters.timeStep;
}

/// @returns number of active contacts
int ExactSelfContact::solveVelocities(const ExactStep& step, ClothState& state, std::vector<ContactPoint>& points) {
  const double h = step.parameters.timeStep;
  active_.clear();
  goals_.clear();
  for (const ContactConstraint& constraint : constraints_) {
    const double excess = constraint.normal.dot(pointOf(constraint, state.positions)) - constraint.offset;
    if (excess < activeGap * step.contact.thickness) {
      active_.push_back(constraint);
      goals_.push_back({-std::max(0.0, excess) / h, Vec3::Zero()});
      points.push_back({state.positions[constraint.vertices[0]], constraint.normal});
    }
  }
  before_ = state.velocities;
  solver_.solve(active_, goals_, inverseMass(step.model), impulseIterations, state.velocities);
  limitSpeeds(inverseMass(step.model), pinSpeed_, before_, state.velocities);
  return static_cast<int>(active_.size());
}

int ExactSelfContact::resolve(const ExactStep& step, ClothState& state, std::vector<ContactPoint>& points) {
  findContactsAtEnd(step, state.positions);
  predicted_.clear();
  guard_.begin();
  pinSpeed_ = pinSpeedOf(step, state.positions);
  int active = 0;
  if (!contacts_.empty()) {
    solvePositions(step, state);
    active = solveVelocities(step, state, points);
  }
  if (!crossings_.empty() && !isCrumpled(step.model, crossings_.size(), step.start)) {
    recover(step, state);
  }
  return active;
}

int ExactSelfContact::intersectionsAtStart() const {
  return crossings_.empty() ? 0 : intersectingPairCount(search_.mesh(), crossings_);
}

/// Moves features apart that intersect at the start of the step.
void ExactSelfContact::recover(const ExactStep& step, ClothState& state) {
  const auto makeField = [&](const ClothModel& model) {
    return std::make_unique<CrossingField>(search_.mesh(), model.vertexMass);
  };
  recoverFromCrossings({.model = step.model,
                        .mesh = search_.mesh(),
                        .field = *crossingField_.get(step.model, makeField),
                        .inverseMass = inverseMass(step.model),
                        .crossings = crossings_,
                        .start = step.start,
                        .margin = recoveryMargin * step.contact.thickness,
                        .timeStep = step.parameters.timeStep},
                       state);
}

/// Guards pairs of different patches until all patches are collision-free.
/// @param history the patches at the start; those at the end are stored here
/// @returns empty if cloth must be moved and this is not permitted
std::optional<PairGuard::Result> ExactSelfContact::keepApart(const ExactStep& step, PairGuard::Inputs inputs,
                                                             bool mayMove, std::vector<Vec3>& positions,
                                                             PatchHistory& history) {
  history = patches_.update(step.model, reachOf(step), positions, history);
  inputs.patches = patches_.ofFeatures(search_.meshOf(step.model), history);
  if (!mayMove) {
    return guard_.resultWithoutMotion(inputs, search_, workers_, positions);
  }
  bool wereRemoved = false;
  for (int round = 0;; ++round) {
    wanted_ = positions;
    const PairGuard::Result result = guard_.apply(inputs, search_, workers_, positions);
    const bool areValid =
        inputs.patches == nullptr || positions == wanted_ || !patches_.removeInvalid(positions, inputs.patches);
    if (areValid) {
      history = wereRemoved ? patches_.update(step.model, reachOf(step), positions, history) : history;
      return result;
    }
    wereRemoved = true;
    if (round == maxPatchRounds) {
      inputs.patches = nullptr;  // checks all pairs
    }
  }
}

std::optional<int> ExactSelfContact::guard(const ExactStep& step, const BodyLimits& bodies, ClothState& state) {
  before_ = state.positions;
  const bool nearBodies = !bodies.fallback.empty();
  const Vec3 common = nearBodies ? Vec3(Vec3::Zero()) : meanDisplacement(step.start, before_);
  const std::span<const Vec3> unmoved = nearBodies ? bodies.fallback : std::span<const Vec3>(step.start);
  const bool bodiesMove = nearBodies && !std::ranges::equal(bodies.fallback, step.start);
  fallback_.resize(before_.size());
  for (std::size_t v = 0; v < before_.size(); ++v) {
    // The guard does not move pins.
    fallback_[v] = step.model.pinned[v] ? before_[v] : Vec3(unmoved[v] + common);
  }
  const auto memory = std::make_shared<SelfContactMemory>();
  memory->vertices = step.model.vertexCount();
  memory->triangles = static_cast<int>(step.model.triangles.size());
  memory->patches = step.memory != nullptr ? step.memory->patches : PatchHistory{};
  const std::optional<PairGuard::Result> result = keepApart(step,
                                                            {.model = step.model,
                                                             .inverseMass = inverseMass(step.model),
                                                             .start = step.start,
                                                             .fallback = fallback_,
                                                             .bodyPlanes = bodies.planes,
                                                             .entangled = entangled_,
                                                             .patches = nullptr,
                                                             .thickness = step.contact.thickness,
                                                             .reach = reachOf(step),
                                                             .obstaclesMove = bodiesMove || pinSpeed_ > 0.0,
                                                             .threads = step.parameters.threads},
                                                            bodies.planesAreComplete, state.positions, memory->patches);
  if (!result) {
    return std::nullopt;
  }
  const Vec3 commonVelocity = common / step.parameters.timeStep;
  removeApproach(
      before_, [&](std::size_t) -> const Vec3& { return commonVelocity; }, step.parameters.timeStep, state);
  state.hasNoSelfIntersection = result->crossings == 0 && result->touching == 0 && entangled_.empty();
  state.selfContact = memory;
  return result->crossings;
}

}  // namespace drape::sim::contact
