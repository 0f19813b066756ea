#include "sim/adaptive/sleep_detection.hpp"

#include "sim/adaptive/settling.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/forces/external_forces.hpp"
#include "sim/model/fingerprint.hpp"
#include "sim/model/normals.hpp"
#include "sim/model/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace drape::sim::adaptive {
namespace {

void addPose(const contact::Pose& pose, Fingerprint& fingerprint) {
  fingerprint.add(pose.position);
  for (int c = 0; c < 4; ++c) {
    fingerprint.add(pose.rotation.coeffs()[c]);
  }
}

bool isStill(const contact::BodyStep& body) {
  return body.start.position == body.end.position && body.start.rotation.coeffs() == body.end.rotation.coeffs() &&
         std::equal(body.startVertices.begin(), body.startVertices.end(), body.endVertices.begin(),
                    body.endVertices.end());
}

/// Whether every vertex is within that distance [m] of its earlier position.
bool areNear(const std::vector<Vec3>& positions, const std::vector<Vec3>& before, double distance) {
  return positions.size() == before.size() &&
         std::equal(positions.begin(), positions.end(), before.begin(),
                    [&](const Vec3& a, const Vec3& b) { return (a - b).squaredNorm() <= distance * distance; });
}

/// Whether the vertices are still near the reference. Of cloth that settles their mean displacement counts.
bool isNearReference(const std::vector<Vec3>& positions, double distance, double errorTolerance,
                     const StepMemory& memory) {
  const std::vector<Vec3>& reference = *memory.sleepReference;
  return areNear(positions, reference, distance) ||
         (isSettling(memory) && positions.size() == reference.size() &&
          hardlyMoved(reference, positions, tuning.settledToleranceFraction * errorTolerance));
}

/// Weight and the air's force on a vertex at rest [N].
Vec3 externalForce(const ClothModel& model, const CommonParameters& parameters, const std::vector<Vec3>& positions,
                   std::size_t vertex) {
  Vec3 weight(0.0, -model.vertexMass[vertex] * parameters.gravity, 0.0);
  const double speed = parameters.air.wind.norm();
  if (speed == 0.0 || !parameters.air.acts()) {
    return weight;
  }
  const double area = model.vertexArea[vertex];
  const double pressureArea = 0.5 * parameters.air.density * area;
  const Vec3 normal = vertexNormal(model, positions, static_cast<int>(vertex));
  const Vec3 heading = -parameters.air.wind / speed;
  if (actsAsPlate(model, parameters.air)) {
    return weight + kernels::plateForce(normal, speed, heading, airFactorsOf(parameters.air, area));
  }
  return weight + kernels::dragForce(normal, speed, heading, pressureArea * parameters.air.drag) +
         kernels::risingLiftForce(normal, speed, heading, pressureArea * parameters.air.lift,
                                  kernels::liftRise(parameters.air.density) * area);
}

/// The displacement of a piece as a whole by weight and air in the time of the trial [m].
Vec3 trialDisplacement(const ClothModel& model, const CommonParameters& parameters, const std::vector<Vec3>& positions,
                       const std::vector<std::size_t>& piece) {
  constexpr double seconds = tuning.supportTrialTime;
  Vec3 force = Vec3::Zero();
  double mass = 0.0;
  for (const std::size_t v : piece) {
    force += externalForce(model, parameters, positions, v);
    mass += model.vertexMass[v];
  }
  return 0.5 * seconds * seconds / mass * force;
}

/// Whether contact removed at least a tenth of a piece's displacement at one of its vertices.
bool isBlocked(const std::vector<std::size_t>& piece, const Vec3& displacement, const std::vector<Vec3>& before,
               const std::vector<Vec3>& after) {
  return std::any_of(piece.begin(), piece.end(), [&](std::size_t v) {
    return (after[v] - before[v]).dot(displacement) < tuning.maxFreeFraction * displacement.squaredNorm();
  });
}

/// A number from -1 to 1 that looks random and depends on the vertex only.
double scatter(std::size_t vertex) {
  Fingerprint fingerprint;
  fingerprint.add(std::uint64_t{vertex});
  return std::ldexp(static_cast<double>(fingerprint.value() >> 11U), -52) - 1.0;
}

/// Moves the free vertices along their normals by up to `distance` [m].
void disturb(const ClothModel& model, double distance, ClothState& state) {
  const std::vector<Vec3> before = state.positions;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (!model.pinned[v]) {
      state.positions[v] += distance * scatter(v) * vertexNormal(model, before, static_cast<int>(v));
    }
  }
}

void forgetReference(StepMemory& memory) {
  memory.sleepReference.reset();
  memory.disturbed = false;
}

void setReference(const ClothState& state, StepMemory& memory) {
  memory.sleepReference = std::make_shared<const std::vector<Vec3>>(state.positions);
  memory.sleepReferenceTime = state.time;
}

bool windActs(const AirParameters& air) {
  return air.acts() && !air.wind.isZero(0.0);
}

/// Whether the state is still the one that fell asleep.
bool isUnchanged(const StepMemory& memory, const ClothState& state) {
  return state.positions == *memory.sleepReference &&
         std::all_of(state.velocities.begin(), state.velocities.end(), [](const Vec3& v) { return v.isZero(0.0); });
}

}  // namespace

bool isUndisturbed(const SleepConditions& conditions) {
  const auto& [parameters, contact, inputs, errorTolerance] = conditions;
  const bool damped = parameters.material.damping > 0.0 || parameters.air.drag > 0.0;
  const bool still = inputs.bodies == nullptr || std::all_of(inputs.bodies->begin(), inputs.bodies->end(), isStill);
  const bool pinsMove = inputs.movedPins != nullptr && !inputs.movedPins->empty();
  return damped && still && !pinsMove && !inputs.attachment;
}

bool SleepDetection::isAsleep(const ClothModel& model, const SleepConditions& conditions, StepMemory& memory,
                              ClothState& state) {
  const ModelData& data = models_.get(model, dataOf);
  if (!canSleep(data, conditions)) {
    forgetReference(memory);
    memory.sleepFingerprint = 0;
    return false;
  }
  if (memory.sleepFingerprint != 0) {
    if (staysAsleep(model, conditions, memory, state)) {
      return true;
    }
    forgetReference(memory);
    memory.sleepFingerprint = 0;
  }
  const double distance =
      std::min(tuning.sleepToleranceFraction * conditions.errorTolerance, tuning.sleepEdgeFraction * data.meanEdge);
  if (memory.sleepReference == nullptr ||
      !isNearReference(state.positions, distance, conditions.errorTolerance, memory)) {
    forgetReference(memory);
    if (memory.steps % tuning.sleepCheckInterval == 0) {
      setReference(state, memory);
    }
    return false;
  }
  if (state.time < memory.sleepReferenceTime + tuning.sleepTime) {
    return false;
  }
  if (!isSupported(model, data, conditions, state)) {
    forgetReference(memory);
    return false;
  }
  if (!memory.disturbed && data.freePieces.empty() && windActs(conditions.parameters.air)) {
    disturb(model, tuning.disturbance * distance, state);
    setReference(state, memory);
    memory.disturbed = true;
    return false;
  }
  std::fill(state.velocities.begin(), state.velocities.end(), Vec3::Zero());
  memory.sleepReference = std::make_shared<const std::vector<Vec3>>(state.positions);
  memory.sleepFingerprint = fingerprintOf(data, conditions);
  return true;
}

bool SleepDetection::staysAsleep(const ClothModel& model, const SleepConditions& conditions, const StepMemory& memory,
                                 const ClothState& state) {
  const ModelData& data = models_.get(model, dataOf);
  return memory.sleepFingerprint != 0 && isUnchanged(memory, state) && canSleep(data, conditions) &&
         memory.sleepFingerprint == fingerprintOf(data, conditions);
}

/// Free cloth can sleep only if there is a body that may support it.
bool SleepDetection::canSleep(const ModelData& data, const SleepConditions& conditions) {
  const bool canBeSupported = data.freePieces.empty() || contact::meetsBodies(conditions.contact, conditions.inputs);
  return canBeSupported && isUndisturbed(conditions);
}

/// Whether bodies support every piece without pins. A trial displaces the piece a little in the direction of weight and
/// air. The piece is supported if contact with bodies blocks the displacement. Cloth that lies on other cloth does not
/// count as supported: self-collision keeps it moving a little.
bool SleepDetection::isSupported(const ClothModel& model, const ModelData& data, const SleepConditions& conditions,
                                 const ClothState& state) {
  if (data.freePieces.empty()) {
    return true;
  }
  ClothState trial = state;
  std::vector<Vec3> displacements;
  for (const std::vector<std::size_t>& piece : data.freePieces) {
    displacements.push_back(trialDisplacement(model, conditions.parameters, state.positions, piece));
    for (const std::size_t v : piece) {
      trial.positions[v] += displacements.back();
      trial.velocities[v] = displacements.back() / conditions.parameters.timeStep;
    }
  }
  contact::ContactParameters withBodies = conditions.contact;
  withBodies.self = contact::SelfCollision::Off;
  contact_.begin(withBodies, conditions.inputs, state);
  static_cast<void>(contact_.resolve(model, conditions.parameters, withBodies, conditions.inputs, trial));
  std::size_t supported = 0;
  while (supported < displacements.size() &&
         isBlocked(data.freePieces[supported], displacements[supported], state.positions, trial.positions)) {
    ++supported;
  }
  return supported == displacements.size();
}

SleepDetection::ModelData SleepDetection::dataOf(const ClothModel& model) {
  ModelData data;
  data.freePieces = freePieces(model);
  data.meanEdge = meanEdge(model);
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < model.vertexMass.size(); ++i) {
    fingerprint.add(model.vertexMass[i]);
    fingerprint.add(std::uint64_t{model.pinned[i]});
  }
  for (const Spring& spring : model.springs) {
    fingerprint.add(static_cast<std::uint64_t>(spring.a));
    fingerprint.add(static_cast<std::uint64_t>(spring.b));
    fingerprint.add(spring.restLength);
    fingerprint.add(spring.relativeStiffness);
  }
  fingerprint.add(model.fabric ? model.fabric->fingerprint : std::uint64_t{0});
  data.fingerprint = fingerprint.value();
  return data;
}

std::uint64_t SleepDetection::fingerprintOf(const ModelData& data, const SleepConditions& conditions) {
  const auto& [parameters, contact, inputs, errorTolerance] = conditions;
  Fingerprint fingerprint;
  fingerprint.add(data.fingerprint);
  for (const double value :
       {parameters.material.stiffness, parameters.material.damping, parameters.gravity, parameters.air.drag,
        parameters.air.lift, parameters.air.edgeDrag, parameters.air.density, errorTolerance, contact.thickness,
        contact.selfThickness, contact.staticFriction, contact.kineticFriction, contact.bodyFriction}) {
    fingerprint.add(value);
  }
  fingerprint.add(parameters.air.wind);
  fingerprint.add(static_cast<std::uint64_t>(parameters.air.model));
  fingerprint.add(std::uint64_t{contact.bodies});
  fingerprint.add(static_cast<std::uint64_t>(contact.self));
  if (inputs.bodies != nullptr) {
    for (const contact::BodyStep& body : *inputs.bodies) {
      addPose(body.start, fingerprint);
      fingerprint.add(body.surface.thickness);
      fingerprint.add(body.surface.staticFriction);
      fingerprint.add(body.surface.kineticFriction);
      std::for_each(body.startVertices.begin(), body.startVertices.end(), [&](const Vec3& v) { fingerprint.add(v); });
    }
  }
  return fingerprint.value();
}

}  // namespace drape::sim::adaptive
