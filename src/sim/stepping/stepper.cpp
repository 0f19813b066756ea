#include "sim/stepping/stepper.hpp"

#include "sim/adaptive/energy_guard.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/fabric/weld.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/local_rates.hpp"
#include "sim/forces/stability.hpp"
#include "sim/model/distances.hpp"
#include "sim/model/pieces.hpp"
#include "sim/model/sim_error.hpp"
#include "sim/motion/moving_frame.hpp"
#include "sim/solvers/self_collision.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace drape::sim {
namespace {

/// The fraction of a BDF2 step that its backward-Euler solve covers.
constexpr double bdf2Part = 2.0 / 3.0;

/// Longest contact substep of any solver. The solver ignores contacts: if n supporting vertices carry the weight of N,
/// they sink into the body by about N/n g h^2 before contact corrects them. The cloth below them stretches by as much
/// and swings. Longer contact substeps add energy.
constexpr double maxContactSubstepTime = 1.0 / 300.0;  // [s]

/// Features of the cloth in contact move past each other by at most this many mean edges in a contact substep. A
/// contact holds near the closest points at its start. Farther away only the guard keeps the features apart. It moves
/// single vertices, which stretches stiff cloth and so adds energy.
constexpr double maxMotionInEdges = 0.35;
constexpr int maxFastContactSubsteps = 16;

/// How often a contact substep is repeated with contacts of the cloth with itself that its list lacked. The correction
/// at its end would move the features apart against the springs, which adds energy. More repetitions find few contacts.
constexpr int maxRepetitions = 3;

/// Solvers that do not resolve contacts repeat a step in up to four times as many contact substeps if contact moved a
/// vertex by more than this many mean edges in one of them. Such a correction stretches springs more than the motion
/// that it stops, and the guard may find no positions.
constexpr double maxCorrectionInEdges = 0.2;
constexpr double maxFinerSubsteps = 4.0;

/// A motion to compare with has this many times as many contact substeps for a damped fabric. Damping acts once in
/// each, and its error is of first order: with half the interval only half of it would show.
constexpr int dampingRefinement = 2;

bool isDamped(const ClothModel& model) {
  return model.fabric && model.fabric->materials.damp();
}

/// Whether a step is repeated in shorter contact substeps if contact moves a vertex too far.
bool repeatsInShorterParts(const SolverInfo& solver, const StepParameters& parameters) {
  return !solver.resolvesContacts && parameters.contact.self == contact::SelfCollision::Exact;
}

/// The largest motion of a vertex in a step relative to the mean motion, with the present velocities [m].
double maxMotion(const ClothState& state, double timeStep) {
  const auto count = static_cast<double>(std::max<std::size_t>(1, state.velocities.size()));
  const Vec3 mean = std::accumulate(state.velocities.begin(), state.velocities.end(), Vec3(Vec3::Zero())) / count;
  double largest = 0.0;  // squared
  for (const Vec3& velocity : state.velocities) {
    largest = std::max(largest, (velocity - mean).squaredNorm());
  }
  return timeStep * std::sqrt(largest);
}

/// Adds the report of a later contact substep of the same step. Overlaps are those at the start of the step.
void addLater(const contact::ContactReport& next, contact::ContactReport& total) {
  total.bodyContacts = std::max(total.bodyContacts, next.bodyContacts);
  total.selfContacts = std::max(total.selfContacts, next.selfContacts);
  total.infeasible += next.infeasible;
  total.crossings += next.crossings;
  total.bodySeconds += next.bodySeconds;
  total.selfSeconds += next.selfSeconds;
}

/// The index of the material with the smallest scale of its stretch stiffness; among equals the one with the largest
/// strain.
int softestOf(const std::vector<adaptive::StretchMemory>& materials) {
  const auto softest = std::ranges::max_element(materials, {}, [](const adaptive::StretchMemory& material) {
    return std::pair{material.level, material.strain};
  });
  return static_cast<int>(softest - materials.begin());
}

/// Lets the time begin anew for which cloth must be at rest before it settles and sleeps.
void keepAwake(ClothState& state) {
  adaptive::StepMemory memory = adaptive::stepMemoryOf(state);
  if (memory.sleepReference != nullptr || memory.sleepFingerprint != 0 || memory.settlingReference != nullptr) {
    memory.sleepReference.reset();
    memory.sleepFingerprint = 0;
    memory.settlingReference.reset();
    memory.slowIntervals = 0;
    adaptive::storeStepMemory(std::move(memory), state);
  }
}

/// The displacements of pins in a part of a step.
std::vector<MovedPin> partOf(const std::vector<MovedPin>* whole, double share) {
  std::vector<MovedPin> part;
  if (whole != nullptr) {
    part = *whole;
  }
  for (MovedPin& pin : part) {
    pin.by *= share;
  }
  return part;
}

/// Whether a pin moves differently from the mean of all pins, `mean` [m].
bool differFrom(const Vec3& mean, const std::vector<MovedPin>& pins) {
  constexpr double rounding = 1e-12;  // [-]
  return std::ranges::any_of(pins,
                             [&](const MovedPin& pin) { return (pin.by - mean).norm() > rounding * pin.by.norm(); });
}

/// The smallest number of equal parts of a time that are at most `longest`; a thousand if there are more.
int partsOf(double time, double longest) {
  constexpr double rounding = 1e-9;  // [-]
  return static_cast<int>(std::clamp(std::ceil(time / longest * (1.0 - rounding)), 1.0, 1000.0));
}

/// A state that was replaced since the last step, as by a new scene, has no history, or one of another size.
bool hasHistory(const ClothState& state, double timeStep) {
  return state.history.timeStep == timeStep && state.history.positions.size() == state.positions.size();
}

}  // namespace

Stepper::Stepper(std::string_view solver) : info_(findSolver(solver)) {
  if (info_ == nullptr) {
    throw UnknownSolver(solver);
  }
  solver_ = info_->make();
}

StepReport Stepper::step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                         ClothState& state) {
  // So that nothing below needs to ask which self-collision and which material act.
  StepParameters acting = parameters;
  acting.contact.self = actingSelfCollision(parameters.contact.self, info_);
  if (!seams_.empty()) {
    keepAwake(state);
  }
  if (!model.fabric) {
    return advance(model, acting, inputs, state);
  }
  if (!info_->takesFabric) {
    throw NoFabricSolver(info_->name);
  }
  acting.material = actingMaterial(model, parameters);
  return info_->choosesSubsteps && parameters.automatic.strainLimit > 0.0
             ? advanceWithChosenStretch(model, acting, inputs, state)
             : advance(model, acting, inputs, state);
}

StepReport Stepper::advanceWithChosenStretch(const ClothModel& model, const StepParameters& parameters,
                                             const StepInputs& inputs, ClothState& state) {
  adaptive::StepMemory memory = adaptive::stepMemoryOf(state);
  const adaptive::StretchConditions conditions{.parameters = parameters,
                                               .options = parameters.automatic,
                                               .meetsBodies = contact::meetsBodies(parameters.contact, inputs),
                                               .isAttached = inputs.attachment.has_value()};
  const ClothModel& chosen = stretch_.choose(model, conditions, state, memory);
  const int softest = softestOf(memory.stretch);
  const adaptive::StretchMemory choice = memory.stretch[softest];
  adaptive::storeStepMemory(std::move(memory), state);
  StepReport report = advance(chosen, parameters, inputs, state);
  if (report.choice) {
    report.choice->stiffnessScale = adaptive::StretchChoice::scaleOf(choice.level);
    report.choice->softestMaterial = softest;
    report.choice->strain = choice.strain;
    report.choice->softenedTriangles = chosen.fabric->slivers - model.fabric->slivers;
    report.choice->fullStiffnessCost = largestFrequency(model, parameters) / largestFrequency(chosen, parameters);
  }
  return report;
}

StepReport Stepper::advance(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                            ClothState& state) {
  earlierContactWork_ = 0.0;
  dampingWork_ = 0.0;
  unsteadyAirWork_ = 0.0;
  contactLoadsAreOld_ = true;
  if (solver_->sleeps(model, parameters, inputs, state)) {
    contactSubsteps_ = 1;
    return stepAsleep(model, parameters, inputs, state);
  }
  const int refinement = info_->choosesSubsteps ? parameters.automatic.refinement : 1;
  if (refinement == 1) {
    dampFabric(model, parameters, inputs, state);
  }
  contactSubsteps_ = contactSubstepsOf(model, parameters, inputs, state) * refinement;
  if (refinement > 1 && isDamped(model)) {
    contactSubsteps_ *= dampingRefinement;
  }
  return repeatsInShorterParts(*info_, parameters) ? stepInShorterParts(model, parameters, inputs, state)
                                                   : stepInParts(model, parameters, inputs, state);
}

/// A step in the present number of contact substeps.
StepReport Stepper::stepInParts(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                ClothState& state) {
  largestCorrection_ = 0.0;
  return contactSubsteps_ == 1 ? stepWithContact(model, parameters, inputs, state)
                               : stepInContactSubsteps(model, parameters, inputs, contactSubsteps_, state);
}

/// A step that is repeated once in shorter contact substeps if contact moved a vertex too far.
StepReport Stepper::stepInShorterParts(const ClothModel& model, const StepParameters& parameters,
                                       const StepInputs& inputs, ClothState& state) {
  contactStart_ = state;
  const StepReport report = stepInParts(model, parameters, inputs, state);
  const double allowed = maxCorrectionInEdges * meanEdge_.get(model, meanEdge);
  if (largestCorrection_ <= allowed) {
    return report;
  }
  contactSubsteps_ *= static_cast<int>(std::clamp(std::ceil(largestCorrection_ / allowed), 2.0, maxFinerSubsteps));
  state = contactStart_;
  earlierContactWork_ = 0.0;
  unsteadyAirWork_ = 0.0;
  contactLoadsAreOld_ = true;
  return stepInParts(model, parameters, inputs, state);
}

/// Sleeping cloth needs no contact.
StepReport Stepper::stepAsleep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                               ClothState& state) {
  StepReport report = solver_->step(model, parameters, inputs, state);
  report.contact = contact_.keepLast();
  return report;
}

void Stepper::dampFabric(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                         ClothState& state) {
  if (!isDamped(model)) {
    return;
  }
  planPins(model, inputs, state);
  std::vector<simd::PinVelocity> pins;
  for (const PinMotion& pin : pinMotions_) {
    pins.push_back({pin.vertex, (pin.to - pin.from) / parameters.timeStep});
  }
  if (!damper_) {
    damper_ = std::make_unique<simd::FabricDamper>();
  }
  dampingWork_ += damper_->damp(model, parameters, pins, state);
}

/// The contact substeps that resolve the motion of flat pieces in the air.
int Stepper::unsteadyAirSubsteps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                 const ClothState& state) {
  beginUnsteadyAir(model, parameters, inputs, state);
  return std::min(maxFastContactSubsteps, partsOf(parameters.timeStep, unsteadyAir_.longestStep()));
}

int Stepper::contactSubstepsOf(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                               const ClothState& state) {
  const int inAir = unsteadyAirSubsteps(model, parameters, inputs, state);
  const int nearContacts = partsOf(parameters.timeStep, maxContactSubstepTime);
  const double allowedMotion = maxMotionInEdges * meanEdge_.get(model, meanEdge);
  const bool couldBeFast = info_->resolvesContacts && parameters.contact.self == contact::SelfCollision::Exact &&
                           2.0 * maxMotion(state, parameters.timeStep) > allowedMotion;
  if (nearContacts <= 1 && !couldBeFast) {
    return inAir;
  }
  const bool isSewing = info_->resolvesContacts && !seams_.empty();
  const contact::SelfApproach itself = info_->resolvesContacts
                                           ? contact_.approachOfItself(model, parameters, parameters.contact, state)
                                           : contact::SelfApproach{};
  const double fast = itself.motion > allowedMotion ? std::ceil(itself.motion / allowedMotion) : 1.0;
  const int fastContacts = std::max(inAir, static_cast<int>(std::min<double>(maxFastContactSubsteps, fast)));
  const bool nearBodies = nearContacts > 1 && contact::meetsBodies(parameters.contact, inputs) &&
                          contact_.isNearBodies(model, parameters, parameters.contact, inputs, state);
  return std::max(itself.isNear || nearBodies || isSewing ? nearContacts : 1, fastContacts);
}

StepReport Stepper::stepInContactSubsteps(const ClothModel& model, const StepParameters& parameters,
                                          const StepInputs& inputs, int contactSubsteps, ClothState& state) {
  const double end = state.time + parameters.timeStep;
  StepParameters part = parameters;
  part.timeStep = parameters.timeStep / contactSubsteps;
  part.substeps = (parameters.substeps + contactSubsteps - 1) / contactSubsteps;
  StepInputs acting = inputs;
  const std::vector<MovedPin> movedPins = partOf(inputs.movedPins, 1.0 / contactSubsteps);
  acting.movedPins = movedPins.empty() ? nullptr : &movedPins;
  // The damping of a fabric is of first order in its interval, which is the step unless a motion to compare with is
  // made.
  const bool refined = info_->choosesSubsteps && parameters.automatic.refinement > 1;
  StepReport total;
  for (int i = 0; i < contactSubsteps; ++i) {
    if (keepsContactWork_ && contact_.unresolved() != nullptr && i > 0) {
      earlierContactWork_ +=
          energyOf(model, parameters, state).total() - energyOf(model, parameters, *contact_.unresolved()).total();
    }
    if (inputs.bodies != nullptr) {
      acting.bodies =
          &bodySubsteps_.between(*inputs.bodies, static_cast<double>(i) / contactSubsteps, (i + 1.0) / contactSubsteps);
    }
    if (refined) {
      dampFabric(model, part, acting, state);
    }
    const StepReport report = stepWithContact(model, part, acting, state);
    total.add(report);
    if (i == 0) {
      total.contact = report.contact;
    } else {
      addLater(report.contact, total.contact);
    }
  }
  state.time = end;
  return total;
}

StepReport Stepper::stepWithContact(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                    ClothState& state) {
  const double end = state.time + parameters.timeStep;
  contact_.begin(parameters.contact, inputs, state);
  planPins(model, inputs, state);
  closing_.plan(seams_, parameters.timeStep, state);
  const StepInputs own = inputsOfSolver(model, parameters, inputs, state);
  beginUnsteadyAir(model, parameters, inputs, state);
  StepReport total = info_->resolvesContacts && parameters.contact.self == contact::SelfCollision::Exact
                         ? moveWithSubstepContacts(model, parameters, own, state)
                         : moveBySolver(model, parameters, own, state);
  if (!(total.choice && total.choice->sleeping)) {
    unsteadyAirWork_ += unsteadyAir_.apply(model, state);
  }
  if (closing_.acts()) {
    closeSeams(model, parameters, state);
  }
  // Contact would move layers apart that are closer than their thickness, and so wake cloth that has fallen asleep.
  total.contact = total.choice && total.choice->sleeping
                      ? contact_.keepLast()
                      : contact_.resolve(model, parameters, parameters.contact, own, state, 1.0 / contactSubsteps_);
  // Moving features apart stretches the cloth. A solver that resolves contacts conserves energy, and would keep this
  // one.
  if (info_->resolvesContacts) {
    adaptive::removeInnerMotion(model, pieces_.get(model, freePieces), total.contact.guardWork, state);
  }
  const ClothState* unresolved = repeatsInShorterParts(*info_, parameters) ? contact_.unresolved() : nullptr;
  if (unresolved != nullptr) {
    largestCorrection_ = std::max(largestCorrection_, largestDistance(unresolved->positions, state.positions));
  }
  if (keepsContactLoads_ && !(total.choice && total.choice->sleeping)) {
    addContactLoads(model, state);
  }
  earlierContactWork_ += total.contactWork;
  dampingWork_ += total.settlingWork;
  state.time = end;  // not the sum of the substeps, which has rounding errors
  return total;
}

void Stepper::beginUnsteadyAir(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                               const ClothState& state) {
  unsteadyAir_.begin(model, parameters, state);
  if (unsteadyAir_.acts() && contact::meetsBodies(parameters.contact, inputs) &&
      contact_.isNearBodies(model, parameters, parameters.contact, inputs, state)) {
    unsteadyAir_.stop();
  }
}

StepReport Stepper::moveBySolver(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                 ClothState& state) {
  StepParameters part = parameters;
  const bool solverMovesPins = info_->resolvesContacts;
  const int substeps = info_->choosesSubsteps && (solverMovesPins || pinMotions_.empty()) ? 1 : parameters.substeps;
  part.timeStep = parameters.timeStep / substeps;
  if (integrationOf(parameters) == Integration::BackwardEuler && !parameters.keepMomentum && pinMotions_.empty()) {
    state.history.timeStep = 0.0;
    const StepReport report = solver_->steps(model, part, inputs, substeps, state);
    advanceSubstepContacts(part.timeStep);
    return report;
  }
  return stepInFrameOfPins(model, part, inputs, substeps, state);
}

StepReport Stepper::moveWithSubstepContacts(const ClothModel& model, const StepParameters& parameters,
                                            StepInputs inputs, ClothState& state) {
  contactStart_ = state;
  startContacts_ = substepContacts_;
  StepReport report = moveBySolver(model, parameters, inputs, state);
  // Contacts of seams must stay the last ones.
  for (int i = 0; i < maxRepetitions && seamContacts_ == 0 && report.choice && !report.choice->sleeping &&
                  contact_.addMissedContacts(model, parameters, parameters.contact, state, startContacts_);
       ++i) {
    const int evaluations = report.choice->forceEvaluations;
    const double contactSeconds = report.substepContactSeconds;
    state = contactStart_;
    substepContacts_ = startContacts_;
    inputs.contacts = &substepContacts_;
    report = moveBySolver(model, parameters, inputs, state);
    report.choice->forceEvaluations += evaluations;
    report.substepContactSeconds += contactSeconds;
  }
  return report;
}

/// Takes the substeps of a step in the frame of reference of the pins. @param parameters of a substep
StepReport Stepper::stepInFrameOfPins(const ClothModel& model, const StepParameters& parameters,
                                      const StepInputs& inputs, int substeps, ClothState& state) {
  StepReport total;
  const Vec3 meanVelocity = meanPinVelocity(model, parameters.timeStep * substeps);
  std::vector<MovedPin> pins = pinDisplacements(substeps);
  // Pins that move differently drift during a substep if the solver moves pins. Otherwise they are at its end from its
  // start.
  const bool pinsDrift = info_->resolvesContacts && differFrom(parameters.timeStep * meanVelocity, pins);
  MovingFrame frame(pinsDrift ? Vec3(Vec3::Zero()) : meanVelocity);
  StepParameters inFrame = parameters;
  inFrame.air = frame.toFrame(inFrame.air);
  StepInputs acting = frame.toFrame(inputs, parameters.timeStep);
  const bool pinsRest = std::ranges::all_of(pins, [](const MovedPin& pin) { return pin.by.isZero(0.0); });
  if (!pinsDrift) {
    std::ranges::for_each(pins, [](MovedPin& pin) { pin.by.setZero(); });  // they are at rest in the frame
  }
  acting.movedPins = pinsRest ? nullptr : &pins;
  for (int i = 0; i < substeps; ++i) {
    const double end = (i + 1.0) / substeps;
    if (!pinsDrift) {
      movePins(end, state);
    }
    frame.enter(model, parameters.timeStep, state);
    total.add(substep(model, inFrame, acting, state));
    frame.leave(model, parameters.timeStep, state);
    movePins(end, state);
    advanceSubstepContacts(parameters.timeStep);
  }
  return total;
}

void Stepper::closeSeams(const ClothModel& model, const StepParameters& parameters, ClothState& state) {
  const double before = keepsContactWork_ ? energyOf(model, parameters, state).total() : 0.0;
  closing_.apply(model, state);
  earlierContactWork_ += keepsContactWork_ ? energyOf(model, parameters, state).total() - before : 0.0;
}

void Stepper::keepContactLoads(bool kept) {
  if (!kept) {
    contactLoads_ = {};
  }
  keepsContactLoads_ = kept;
}

void Stepper::addContactLoads(const ClothModel& model, const ClothState& state) {
  if (std::exchange(contactLoadsAreOld_, false)) {
    contactLoads_.begin(model);
  }
  contactLoads_.add(model, std::span(substepContacts_).first(substepContacts_.size() - seamContacts_), state.positions);
  if (const ClothState* unresolved = contact_.unresolved()) {
    contactLoads_.addCorrection(model, *unresolved, state);
  }
}

StepInputs Stepper::inputsOfSolver(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                   ClothState& state) {
  StepInputs own = inputs;
  substepContacts_.clear();
  seamContacts_ = 0;
  if (info_->resolvesContacts) {
    contact_.findSubstepContacts(model, parameters, parameters.contact, inputs, state, substepContacts_);
    const std::size_t contacts = substepContacts_.size();
    closing_.appendContacts(substepContacts_);
    seamContacts_ = substepContacts_.size() - contacts;
    own.contacts = substepContacts_.empty() ? nullptr : &substepContacts_;
  }
  return own;
}

/// Moves the surfaces of the contacts to the end of a substep.
void Stepper::advanceSubstepContacts(double timeStep) {
  for (SubstepContact& contact : substepContacts_) {
    contact.height += timeStep * contact.normal.dot(contact.bodyVelocity);
  }
}

void Stepper::planPins(const ClothModel& model, const StepInputs& inputs, const ClothState& state) {
  pinMotions_.clear();
  const auto plan = [&](int vertex, const auto& endOf) {
    const auto v = static_cast<std::size_t>(vertex);
    if (model.pinned[v]) {
      pinMotions_.push_back({v, state.positions[v], endOf(state.positions[v])});
    }
  };
  if (inputs.bodies != nullptr) {
    for (const contact::BodyStep& body : *inputs.bodies) {
      for (const contact::CarriedPin& pin : body.body->pins) {
        plan(pin.vertex, [&](const Vec3& from) { return contact::carriedBy(body, pin, from); });
      }
    }
  }
  if (inputs.movedPins != nullptr) {
    for (const MovedPin& pin : *inputs.movedPins) {
      plan(pin.vertex, [&](const Vec3& from) { return Vec3(from + pin.by); });
    }
  }
}

void Stepper::movePins(double fraction, ClothState& state) const {
  for (const PinMotion& pin : pinMotions_) {
    state.positions[pin.vertex] = pin.from + fraction * (pin.to - pin.from);
  }
}

/// The displacement of each moving pin in a substep.
std::vector<MovedPin> Stepper::pinDisplacements(int substeps) const {
  std::vector<MovedPin> pins;
  for (const PinMotion& pin : pinMotions_) {
    pins.push_back({static_cast<int>(pin.vertex), (pin.to - pin.from) / substeps});
  }
  return pins;
}

/// The mean velocity of all pins if the moving ones take that time [m/s].
Vec3 Stepper::meanPinVelocity(const ClothModel& model, double seconds) const {
  Vec3 sum = Vec3::Zero();
  if (pinMotions_.empty()) {
    return sum;
  }
  for (const PinMotion& pin : pinMotions_) {
    sum += pin.to - pin.from;
  }
  const std::vector<bool> own = fabric::ownPinsOf(model);
  const auto pins = std::count(own.begin(), own.end(), true);
  return sum / (static_cast<double>(pins) * seconds);
}

StepReport Stepper::substep(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                            ClothState& state) {
  // The impulses of contacts change the momentum. Solvers that apply them conserve it otherwise.
  if (!parameters.keepMomentum || inputs.contacts != nullptr) {
    return integrate(model, parameters, inputs, state);
  }
  const double driftTime = driftFraction(parameters, state) * parameters.timeStep;
  momentum_.prepare(model, parameters, inputs, state);
  const StepReport report = integrate(model, parameters, inputs, state);
  momentum_.correct(model, parameters.timeStep, driftTime, state);
  return report;
}

Integration Stepper::integrationOf(const StepParameters& parameters) const {
  return info_->backwardEuler ? parameters.integration : Integration::BackwardEuler;
}

double Stepper::driftFraction(const StepParameters& parameters, const ClothState& state) const {
  switch (integrationOf(parameters)) {
    case Integration::Theta:
      return parameters.theta;
    case Integration::Bdf2:
      return hasHistory(state, parameters.timeStep) ? bdf2Part : 1.0;
    case Integration::BackwardEuler:
      break;
  }
  return 1.0;
}

StepReport Stepper::integrate(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                              ClothState& state) {
  const Integration integration = integrationOf(parameters);
  if (integration != Integration::Bdf2) {
    state.history.timeStep = 0.0;
  }
  switch (integration) {
    case Integration::Theta:
      return thetaStep(model, parameters, inputs, state);
    case Integration::Bdf2:
      return bdf2Step(model, parameters, inputs, state);
    case Integration::BackwardEuler:
      break;
  }
  return solver_->step(model, parameters, inputs, state);
}

StepReport Stepper::thetaStep(const ClothModel& model, StepParameters parameters, const StepInputs& inputs,
                              ClothState& state) {
  before_.positions = state.positions;
  before_.velocities = state.velocities;
  parameters.timeStep *= parameters.theta;
  const StepReport report = solver_->step(model, parameters, inputs, state);
  const double scale = 1.0 / parameters.theta;
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    state.positions[i] = before_.positions[i] + scale * (state.positions[i] - before_.positions[i]);
    state.velocities[i] = before_.velocities[i] + scale * (state.velocities[i] - before_.velocities[i]);
  }
  return report;
}

StepReport Stepper::bdf2Step(const ClothModel& model, StepParameters parameters, const StepInputs& inputs,
                             ClothState& state) {
  before_.positions = state.positions;
  before_.velocities = state.velocities;
  const double timeStep = parameters.timeStep;
  if (hasHistory(state, timeStep)) {
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      // A vertex that was pinned since the last step still has a history of motion.
      if (!model.pinned[i]) {
        state.positions[i] += (state.positions[i] - state.history.positions[i]) / 3.0;
        state.velocities[i] += (state.velocities[i] - state.history.velocities[i]) / 3.0;
      }
    }
    parameters.timeStep *= bdf2Part;
  }
  const StepReport report = solver_->step(model, parameters, inputs, state);
  state.history.positions.swap(before_.positions);
  state.history.velocities.swap(before_.velocities);
  state.history.timeStep = timeStep;
  return report;
}

}  // namespace drape::sim
