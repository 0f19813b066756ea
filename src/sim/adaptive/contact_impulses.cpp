#include "sim/adaptive/contact_impulses.hpp"

#include "sim/model/disjoint_sets.hpp"
#include "sim/simd/lane_vector.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numeric>

namespace drape::sim::adaptive {
namespace {

/// Relative change of an impulse that counts as converged. Friction that has not converged acts like a viscous force:
/// cloth would creep and never come to rest.
constexpr double converged = 0.001;

/// Maximum number of sweeps over the contacts of an island in a substep. Slow layers that lie on each other need more.
constexpr int maxSweeps = 6;
constexpr int maxSweepsOfSlow = 60;
constexpr double slowSpeed = 0.1;  // [m/s]

/// A contact that slips more slowly than this still has the static coefficient. Substeps are so short that rounding and
/// vibrations of stiff cloth move a vertex at rest by as much as its weight does. With the kinetic coefficient it would
/// never come to rest again. The coefficient of real friction falls to the kinetic one in the same range of speeds
/// (Stribeck's curve). Larger: cloth begins to slide later.
constexpr double slowSlip = 5e-3;  // [m/s]

/// Maximum ratio of the speed that contact gives a vertex to the speed of the fastest body or pin [-].
constexpr double speedRatio = 3.0;
constexpr double harmlessSpeed = 2.0;  // the limit is at least this [m/s]

}  // namespace

template <typename T>
void ContactImpulses<T>::prepare(const StepInputs& inputs, const simd::SlicedCloth<T>& cloth) {
  vertices_.clear();
  single_.clear();
  coupled_.clear();
  coupledVertices_.clear();
  islands_.clear();
  if (inputs.contacts == nullptr) {
    return;
  }
  const auto lanes = static_cast<std::size_t>(cloth.layout.slices()) * simd::sliceLanes;
  slots_.assign(lanes, 0);
  for (const SubstepContact& contact : *inputs.contacts) {
    for (std::size_t c = 0; c < contact.weights.size(); ++c) {
      if (contact.weights[c] != 0.0) {
        slots_[cloth.layout.indexOf[contact.vertices[c]]] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    if (slots_[i] != 0) {
      slots_[i] = vertices_.size();
      const auto mass = static_cast<double>(cloth.mass.data()[i]);
      const bool isFree = cloth.free.data()[i] != T(0);
      vertices_.push_back({.index = static_cast<int>(i), .mass = mass, .inverseMass = isFree ? 1.0 / mass : 0.0});
    }
  }
  for (std::size_t i = 0; i < inputs.contacts->size(); ++i) {
    addContact((*inputs.contacts)[i], i, inputs.frameVelocity, cloth);
  }
  separateCoupled();
  findIslands();
  taken_.assign(islands_.size(), 0);
}

template <typename T>
void ContactImpulses<T>::addContact(const SubstepContact& from, std::size_t source, const Vec3& frameVelocity,
                                    const simd::SlicedCloth<T>& cloth) {
  Contact contact{.normal = from.normal,
                  .isFeaturePair = from.isFeaturePair,
                  .staticFriction = from.staticFriction,
                  .kineticFriction = from.kineticFriction,
                  .restGap = from.restGap,
                  .source = source};
  double total = 0.0;
  for (std::size_t c = 0; c < from.weights.size(); ++c) {
    const double weight = from.weights[c];
    if (weight != 0.0) {
      const std::size_t slot = slots_[cloth.layout.indexOf[from.vertices[c]]];
      contact.vertices[contact.count] = static_cast<std::uint32_t>(slot);
      contact.weights[contact.count++] = weight;
      contact.inverseMass += weight * weight * vertices_[slot].inverseMass;
      total += weight;
    }
  }
  contact.height = from.height - total * from.normal.dot(cloth.origin);
  contact.bodyVelocity = from.bodyVelocity - total * frameVelocity;
  contact.normalSpeed = from.normal.dot(contact.bodyVelocity);
  if (contact.inverseMass > 0.0) {
    coupled_.push_back(contact);
  }
}

template <typename T>
void ContactImpulses<T>::separateCoupled() {
  contactCount_.assign(vertices_.size(), 0);
  for (const Contact& contact : coupled_) {
    for (std::size_t c = 0; c < contact.count; ++c) {
      ++contactCount_[contact.vertices[c]];
    }
  }
  const auto isSingle = [&](const Contact& contact) {
    return contact.count == 1 && contactCount_[contact.vertices[0]] == 1;
  };
  std::ranges::copy_if(coupled_, std::back_inserter(single_), isSingle);
  std::erase_if(coupled_, isSingle);
  std::ranges::sort(single_, {}, [](const Contact& contact) { return contact.vertices[0]; });
}

/// A vertex of a contact that is not pinned. Every contact has one.
template <typename T>
std::size_t ContactImpulses<T>::freeVertexOf(const Contact& contact) const {
  return *std::ranges::find_if(contact.vertices, [&](std::size_t v) { return vertices_[v].inverseMass > 0.0; });
}

/// Sorts the coupled contacts and their free vertices by island. Pinned vertices do not couple contacts, since their
/// velocities are given.
template <typename T>
void ContactImpulses<T>::findIslands() {
  DisjointSets sets(vertices_.size());
  for (const Contact& contact : coupled_) {
    const auto free = static_cast<int>(freeVertexOf(contact));
    forEachFreeVertex(contact, [&](std::uint32_t v) { sets.join(free, static_cast<int>(v)); });
  }
  // An island is named by its lowest vertex.
  const auto islandOf = [&](std::size_t vertex) {
    return static_cast<std::size_t>(sets.root(static_cast<int>(vertex)));
  };
  std::vector<unsigned char> isCoupled(vertices_.size(), 0);
  const auto contacts = RaggedRows<std::uint32_t>::collect(vertices_.size(), [&](const auto& add) {
    for (std::uint32_t i = 0; i < coupled_.size(); ++i) {
      add(islandOf(freeVertexOf(coupled_[i])), i);
      forEachFreeVertex(coupled_[i], [&](std::uint32_t v) { isCoupled[v] = 1; });
    }
  });
  const auto vertices = RaggedRows<std::uint32_t>::collect(vertices_.size(), [&](const auto& add) {
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (isCoupled[v] != 0) {
        add(islandOf(v), v);
      }
    }
  });
  sorted_.clear();
  std::ranges::transform(contacts.values(), std::back_inserter(sorted_), [&](std::uint32_t i) { return coupled_[i]; });
  coupled_.swap(sorted_);
  coupledVertices_ = vertices.values();
  listIslands(contacts, vertices);
}

/// @param contacts and vertices of each island; coupled_ and coupledVertices_ have the same order
template <typename T>
void ContactImpulses<T>::listIslands(const RaggedRows<std::uint32_t>& contacts,
                                     const RaggedRows<std::uint32_t>& vertices) {
  std::span<Contact> restOfContacts(coupled_);
  std::span<const std::uint32_t> restOfVertices(coupledVertices_);
  for (std::size_t island = 0; island < contacts.rowCount(); ++island) {
    if (contacts[island].empty()) {
      continue;
    }
    const std::span<Contact> own = restOfContacts.first(contacts[island].size());
    islands_.push_back(
        {own, restOfVertices.first(vertices[island].size()), std::ranges::any_of(own, &Contact::isFeaturePair)});
    restOfContacts = restOfContacts.subspan(contacts[island].size());
    restOfVertices = restOfVertices.subspan(vertices[island].size());
  }
}

template <typename T>
std::span<typename ContactImpulses<T>::Vertex> ContactImpulses<T>::verticesOf(const simd::StepShare& share) {
  const auto first = std::ranges::lower_bound(vertices_, share.begin * simd::sliceLanes, {}, &Vertex::index);
  const auto last = std::ranges::lower_bound(vertices_, share.end * simd::sliceLanes, {}, &Vertex::index);
  return {first, last};
}

template <typename T>
typename ContactImpulses<T>::IslandRange ContactImpulses<T>::islandsOf(const simd::StepShare& share) const {
  const auto firstVertex = [&](const Island& island) { return vertices_[island.vertices.front()].index; };
  const auto first = std::ranges::lower_bound(islands_, share.begin * simd::sliceLanes, {}, firstVertex);
  const auto last = std::ranges::lower_bound(islands_, share.end * simd::sliceLanes, {}, firstVertex);
  return {static_cast<std::size_t>(first - islands_.begin()), static_cast<std::size_t>(last - islands_.begin())};
}

template <typename T>
void ContactImpulses<T>::start(const simd::SlicedCloth<T>& cloth, const simd::StepShare& share) {
  for (Vertex& vertex : verticesOf(share)) {
    vertex.before = simd::laneVector(cloth.velocity, vertex.index);
  }
}

template <typename T>
void ContactImpulses<T>::applySingle(simd::SlicedCloth<T>& cloth, double time, double drift,
                                     const simd::StepShare& share) {
  const std::span<Vertex> own = verticesOf(share);
  for (Vertex& vertex : own) {
    vertex.velocity = vertex.afterKick = simd::laneVector(cloth.velocity, vertex.index);
  }
  const auto [firstIsland, lastIsland] = islandsOf(share);
  std::fill(taken_.begin() + firstIsland, taken_.begin() + lastIsland, static_cast<unsigned char>(0));
  const auto begin = static_cast<std::size_t>(own.data() - vertices_.data());
  const auto vertexOf = [](const Contact& contact) { return contact.vertices[0]; };
  const auto first = std::ranges::lower_bound(single_, begin, {}, vertexOf);
  const auto last = std::ranges::lower_bound(single_, begin + own.size(), {}, vertexOf);
  for (auto contact = first; contact != last; ++contact) {
    contact->normalImpulse = 0.0;
    contact->friction = Vec3::Zero();
    contact->minSpeed = minSpeedOf(cloth, time, drift, *contact);
    solve(*contact);
    if (contact->normalImpulse > 0.0) {
      contact->impulse += contact->normalImpulse * contact->normal + contact->friction;
      write(vertices_[contact->vertices[0]], drift, cloth);
    }
  }
}

template <typename T>
void ContactImpulses<T>::applyCoupled(simd::SlicedCloth<T>& cloth, double time, double drift,
                                      const simd::StepShare& share) {
  const auto [first, last] = islandsOf(share);
  for (std::size_t i = first; i < last; ++i) {
    if (take(i)) {
      applyIsland(islands_[i], time, drift, cloth);
    }
  }
  // The islands of other threads, backwards, since their threads take them forwards.
  for (std::size_t i = islands_.size(); i > 0; --i) {
    if (take(i - 1)) {
      applyIsland(islands_[i - 1], time, drift, cloth);
    }
  }
}

/// @return false if another thread has taken the island
template <typename T>
bool ContactImpulses<T>::take(std::size_t island) {
  const std::atomic_ref taken(taken_[island]);
  // Barriers order the data of the islands.
  return taken.load(std::memory_order_relaxed) == 0 && taken.exchange(1, std::memory_order_relaxed) == 0;
}

template <typename T>
void ContactImpulses<T>::applyIsland(const Island& island, double time, double drift, simd::SlicedCloth<T>& cloth) {
  for (Contact& contact : island.contacts) {
    contact.minSpeed = minSpeedOf(cloth, time, drift, contact);
  }
  solveIsland(island);
  limitSpeeds(island);
  for (const std::size_t v : island.vertices) {
    write(vertices_[v], drift, cloth);
  }
}

/// Bodies or pins that close like scissors would push vertices out of the gap at any speed. So contact may not give a
/// vertex a higher speed than `harmlessSpeed`, the speed of the fastest vertex before, or `speedRatio` times that of
/// the fastest body or pin, whichever is the highest. Contact that does not increase the kinetic energy of the island
/// has no limit, since it only passes on the motion of the cloth. Neither has contact without moving bodies and pins,
/// which adds no energy.
template <typename T>
void ContactImpulses<T>::limitSpeeds(const Island& island) {
  double before = 0.0;  // squared
  double after = 0.0;   // squared
  double gained = 0.0;  // twice the kinetic energy
  for (const std::size_t v : island.vertices) {
    const double squaredBefore = vertices_[v].afterKick.squaredNorm();
    const double squaredAfter = vertices_[v].velocity.squaredNorm();
    before = std::max(before, squaredBefore);
    after = std::max(after, squaredAfter);
    gained += vertices_[v].mass * (squaredAfter - squaredBefore);
  }
  if (after <= before || gained <= 0.0) {
    return;
  }
  const double ofObstacles = squaredSpeedOfObstacles(island);
  const double limit = std::max({before, speedRatio * speedRatio * ofObstacles, harmlessSpeed * harmlessSpeed});
  if (ofObstacles == 0.0 || after <= limit) {
    return;
  }
  for (const std::size_t v : island.vertices) {
    const double squared = vertices_[v].velocity.squaredNorm();
    if (squared > limit) {
      vertices_[v].velocity *= std::sqrt(limit / squared);
    }
  }
  for (Contact& contact : island.contacts) {
    contact.normalImpulse = 0.0;
    contact.friction = Vec3::Zero();
  }
}

/// The maximum of the bodies and the pins [m^2/s^2]; 0 if none moves.
template <typename T>
double ContactImpulses<T>::squaredSpeedOfObstacles(const Island& island) const {
  double squared = 0.0;
  for (const Contact& contact : island.contacts) {
    const bool isWithBody = std::accumulate(contact.weights.begin(), contact.weights.end(), 0.0) > 0.5;
    squared = std::max(squared, isWithBody ? contact.bodyVelocity.squaredNorm() : 0.0);
    for (std::size_t c = 0; c < contact.count; ++c) {
      const Vertex& vertex = vertices_[contact.vertices[c]];
      squared = std::max(squared, vertex.inverseMass > 0.0 ? 0.0 : vertex.afterKick.squaredNorm());
    }
  }
  return squared;
}

template <typename T>
bool ContactImpulses<T>::isSlow(const Island& island) const {
  return std::ranges::all_of(island.vertices,
                             [&](std::size_t v) { return vertices_[v].before.squaredNorm() < slowSpeed * slowSpeed; });
}

template <typename T>
void ContactImpulses<T>::solveIsland(const Island& island) {
  for (const Contact& contact : island.contacts) {
    if (contact.normalImpulse > 0.0) {
      apply(contact.normalImpulse * contact.normal + contact.friction, contact);
    }
  }
  const int sweeps = island.hasFeaturePairs && isSlow(island) ? maxSweepsOfSlow : maxSweeps;
  bool changes = true;
  for (int sweep = 0; sweep < sweeps && changes; ++sweep) {
    changes = false;
    for (Contact& contact : island.contacts) {
      changes = solve(contact) || changes;
    }
  }
  for (Contact& contact : island.contacts) {
    contact.impulse += contact.normalImpulse * contact.normal + contact.friction;
  }
}

/// The lower bound of the normal velocity of a contact [m/s]. It does not depend on the impulses of the substep.
template <typename T>
double ContactImpulses<T>::minSpeedOf(const simd::SlicedCloth<T>& cloth, double time, double drift,
                                      const Contact& contact) const {
  double gapAtEnd = -contact.height - contact.normalSpeed * time;
  double along = -contact.normalSpeed;
  for (std::size_t c = 0; c < contact.count; ++c) {
    const Vertex& vertex = vertices_[contact.vertices[c]];
    gapAtEnd += contact.weights[c] * contact.normal.dot(simd::laneVector(cloth.position, vertex.index));
    along += contact.weights[c] * contact.normal.dot(vertex.afterKick);
  }
  const double gap = gapAtEnd - drift * along;
  return gap > contact.restGap ? -gap / drift : 0.0;
}

/// Changes the impulse of a contact in a substep so that the contact is satisfied.
/// @return whether the impulse has changed noticeably
template <typename T>
bool ContactImpulses<T>::solve(Contact& contact) {
  Vec3 relative = -contact.bodyVelocity;
  for (std::size_t c = 0; c < contact.count; ++c) {
    relative += contact.weights[c] * vertices_[contact.vertices[c]].velocity;
  }
  const double along = contact.normal.dot(relative);
  if (contact.normalImpulse == 0.0 && !(along < contact.minSpeed)) {
    return false;
  }
  const double normal = std::max(0.0, contact.normalImpulse + (contact.minSpeed - along) / contact.inverseMass);
  Vec3 friction = contact.friction - (relative - along * contact.normal) / contact.inverseMass;
  const double size = friction.norm();
  const double sticking = contact.staticFriction * normal;
  if (size > sticking) {
    const bool isSlow = (size - sticking) * contact.inverseMass < slowSlip;
    friction *= (isSlow ? sticking : contact.kineticFriction * normal) / size;
  }
  const Vec3 change = (normal - contact.normalImpulse) * contact.normal + friction - contact.friction;
  apply(change, contact);
  contact.normalImpulse = normal;
  contact.friction = friction;
  return change.squaredNorm() > converged * converged * normal * normal;
}

template <typename T>
void ContactImpulses<T>::apply(const Vec3& impulse, const Contact& contact) {
  for (std::size_t c = 0; c < contact.count; ++c) {
    Vertex& vertex = vertices_[contact.vertices[c]];
    if (vertex.inverseMass > 0.0) {  // islands of other threads may read pinned vertices
      vertex.velocity += contact.weights[c] * vertex.inverseMass * impulse;
    }
  }
}

/// Writes the velocity of a vertex, and the position as if the impulses had acted before the drift.
template <typename T>
void ContactImpulses<T>::write(const Vertex& vertex, double drift, simd::SlicedCloth<T>& cloth) {
  const Vec3 position = simd::laneVector(cloth.position, vertex.index) + drift * (vertex.velocity - vertex.afterKick);
  simd::setLaneVector(cloth.velocity, vertex.index, vertex.velocity);
  simd::setLaneVector(cloth.position, vertex.index, position);
}

template <typename T>
void ContactImpulses<T>::addWork(const simd::StepShare& share) {
  for (Vertex& vertex : verticesOf(share)) {
    vertex.work += 0.5 * vertex.mass * (vertex.velocity - vertex.afterKick).dot(vertex.before + vertex.velocity);
    vertex.before = vertex.velocity;
  }
}

template <typename T>
double ContactImpulses<T>::work() const {
  double sum = 0.0;
  for (const Vertex& vertex : vertices_) {
    sum += vertex.work;
  }
  return sum;
}

template <typename T>
void ContactImpulses<T>::store(std::vector<SubstepContact>& contacts) const {
  for (const std::vector<Contact>* list : {&single_, &coupled_}) {
    for (const Contact& contact : *list) {
      contacts[contact.source].impulse = contact.impulse;
    }
  }
}

template class ContactImpulses<float>;
template class ContactImpulses<double>;

}  // namespace drape::sim::adaptive
