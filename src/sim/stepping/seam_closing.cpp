#include "sim/stepping/seam_closing.hpp"

#include <algorithm>

namespace drape::sim {
namespace {

constexpr double decayTime = 0.05;  // of the distance at the end, or after something was in the way [s]
constexpr double maxSpeed = 4.0;    // at which a pair closes [m/s]
constexpr int sweeps = 4;           // over pairs, which can have common vertices

/// In the substeps closer pairs keep to their planned motion in all directions. Otherwise the cloth moves their
/// vertices past each other, and the correction at the end of the part stretches it. This changes the angular momentum,
/// but little, since the vertices are close.
constexpr double closeDistance = 0.01;  // [m]
constexpr double sticking = 1e6;        // coefficient of friction [-]

double inverseMassOf(const ClothModel& model, int vertex) {
  return model.pinned[vertex] ? 0.0 : 1.0 / model.vertexMass[vertex];
}

/// Changes the offset between the vertices of a pair by `change` [m], by an impulse.
void changeOffset(const SeamPair& pair, const Vec3& change, double timeStep, const ClothModel& model,
                  ClothState& state) {
  const double first = inverseMassOf(model, pair.a);
  const double second = inverseMassOf(model, pair.b);
  if (first + second <= 0.0) {
    return;
  }
  const Vec3 ofFirst = first / (first + second) * change;
  const Vec3 ofSecond = -second / (first + second) * change;
  state.positions[pair.a] += ofFirst;
  state.positions[pair.b] += ofSecond;
  state.velocities[pair.a] += ofFirst / timeStep;
  state.velocities[pair.b] += ofSecond / timeStep;
}

}  // namespace

void SeamClosing::plan(std::span<const Seam> seams, double timeStep, const ClothState& state) {
  pairs_.clear();
  timeStep_ = timeStep;
  for (const Seam& seam : seams) {
    const double remaining = std::max({seam.start + seam.duration - state.time, decayTime, timeStep});
    for (const SeamPair& pair : seam.pairs) {
      const Vec3 offset = state.positions[pair.a] - state.positions[pair.b];
      const double distance = offset.norm();
      if (distance > 0.0) {
        const double speed = std::min(distance / remaining, maxSpeed);
        pairs_.push_back({pair, offset / distance, distance, std::max(0.0, distance - speed * timeStep)});
      }
    }
  }
}

void SeamClosing::appendContacts(std::vector<SubstepContact>& contacts) const {
  for (const Pair& pair : pairs_) {
    const double speed = (pair.distance - pair.maxDistance) / timeStep_;
    SubstepContact contact;
    contact.vertices = {pair.vertices.a, pair.vertices.b, pair.vertices.b, pair.vertices.b};
    contact.weights = {1.0, -1.0, 0.0, 0.0};
    contact.normal = -pair.direction;
    contact.height = -pair.distance;
    contact.bodyVelocity = speed * contact.normal;
    if (pair.distance < closeDistance) {
      contact.staticFriction = contact.kineticFriction = sticking;
      SubstepContact opposite = contact;
      opposite.normal = -contact.normal;
      opposite.height = -contact.height;
      contacts.push_back(opposite);
    }
    contacts.push_back(contact);
  }
}

/// @return whether the pair was too far apart
bool SeamClosing::draw(const Pair& pair, const ClothModel& model, ClothState& state) const {
  const auto offset = [&] { return Vec3(state.positions[pair.vertices.a] - state.positions[pair.vertices.b]); };
  // Along the direction at the start, which conserves the angular momentum.
  const double along = pair.direction.dot(offset());
  if (along > pair.maxDistance) {
    changeOffset(pair.vertices, (pair.maxDistance - along) * pair.direction, timeStep_, model, state);
  }
  // What is left in a pair that turns.
  const Vec3 rest = offset();
  const double distance = rest.norm();
  if (distance > pair.maxDistance) {
    changeOffset(pair.vertices, (pair.maxDistance / distance - 1.0) * rest, timeStep_, model, state);
  }
  return along > pair.maxDistance || distance > pair.maxDistance;
}

void SeamClosing::apply(const ClothModel& model, ClothState& state) const {
  bool changed = false;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const Pair& pair : pairs_) {
      changed = draw(pair, model, state) || changed;
    }
  }
  if (changed) {
    state.history.timeStep = 0.0;  // a multistep method must not continue the motion before
  }
}

}  // namespace drape::sim
