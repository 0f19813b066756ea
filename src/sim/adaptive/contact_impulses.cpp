#include "sim/adaptive/contact_impulses.hpp"

#include "sim/model/disjoint_sets.hpp"
#include "sim/simd/lane_vector.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>

namespace drape::sim::adaptive {

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
      vertices_.push_back({.inverseMass = isFree ? 1.0 / mass : 0.0, .mass = mass, .index = static_cast<int>(i)});
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
  ImpulseContact contact{.normal = from.normal,
                         .restGap = static_cast<float>(from.restGap),
                         .isFeaturePair = from.isFeaturePair,
                         .staticFriction = from.staticFriction,
                         .kineticFriction = from.kineticFriction,
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
  if (contact.inverseMass > 0.0) {
    coupled_.push_back(contact);
  }
}

template <typename T>
void ContactImpulses<T>::separateCoupled() {
  contactCount_.assign(vertices_.size(), 0);
  for (const ImpulseContact& contact : coupled_) {
    for (std::size_t c = 0; c < contact.count; ++c) {
      ++contactCount_[contact.vertices[c]];
    }
  }
  const auto isSingle = [&](const ImpulseContact& contact) {
    return contact.count == 1 && contactCount_[contact.vertices[0]] == 1;
  };
  std::ranges::copy_if(coupled_, std::back_inserter(single_), isSingle);
  std::erase_if(coupled_, isSingle);
  std::ranges::sort(single_, {}, [](const ImpulseContact& contact) { return contact.vertices[0]; });
}

/// A vertex of a contact that is not pinned. Every contact has one.
template <typename T>
std::size_t ContactImpulses<T>::freeVertexOf(const ImpulseContact& contact) const {
  return *std::ranges::find_if(contact.vertices, [&](std::size_t v) { return vertices_[v].inverseMass > 0.0; });
}

/// Sorts the coupled contacts and their free vertices by island. Pinned vertices do not couple contacts, since their
/// velocities are given.
template <typename T>
void ContactImpulses<T>::findIslands() {
  DisjointSets sets(vertices_.size());
  for (const ImpulseContact& contact : coupled_) {
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
  std::span<ImpulseContact> restOfContacts(coupled_);
  std::span<const std::uint32_t> restOfVertices(coupledVertices_);
  near_.resize(coupled_.size());
  std::span<std::uint32_t> restOfNear(near_);
  for (std::size_t island = 0; island < contacts.rowCount(); ++island) {
    if (contacts[island].empty()) {
      continue;
    }
    const std::span<ImpulseContact> own = restOfContacts.first(contacts[island].size());
    islands_.push_back({.contacts = own,
                        .vertices = restOfVertices.first(vertices[island].size()),
                        .near = restOfNear.first(own.size()),
                        .hasFeaturePairs = std::ranges::any_of(own, &ImpulseContact::isFeaturePair)});
    restOfContacts = restOfContacts.subspan(contacts[island].size());
    restOfVertices = restOfVertices.subspan(vertices[island].size());
    restOfNear = restOfNear.subspan(own.size());
  }
}

template <typename T>
std::span<ContactVertex> ContactImpulses<T>::verticesOf(const simd::StepShare& share) {
  const auto first = std::ranges::lower_bound(vertices_, share.begin * simd::sliceLanes, {}, &ContactVertex::index);
  const auto last = std::ranges::lower_bound(vertices_, share.end * simd::sliceLanes, {}, &ContactVertex::index);
  return {first, last};
}

template <typename T>
typename ContactImpulses<T>::IslandRange ContactImpulses<T>::islandsOf(const simd::StepShare& share) const {
  const auto firstVertex = [&](const ContactIsland& island) { return vertices_[island.vertices.front()].index; };
  const auto first = std::ranges::lower_bound(islands_, share.begin * simd::sliceLanes, {}, firstVertex);
  const auto last = std::ranges::lower_bound(islands_, share.end * simd::sliceLanes, {}, firstVertex);
  return {static_cast<std::size_t>(first - islands_.begin()), static_cast<std::size_t>(last - islands_.begin())};
}

template <typename T>
void ContactImpulses<T>::start(const simd::SlicedCloth<T>& cloth, const simd::StepShare& share) {
  for (ContactVertex& vertex : verticesOf(share)) {
    vertex.before = simd::laneVector(cloth.velocity, vertex.index);
  }
}

template <typename T>
void ContactImpulses<T>::applySingle(simd::SlicedCloth<T>& cloth, double time, double drift,
                                     const simd::StepShare& share) {
  const std::span<ContactVertex> own = verticesOf(share);
  for (ContactVertex& vertex : own) {
    vertex.position = simd::laneVector(cloth.position, vertex.index);
    vertex.velocity = vertex.afterKick = simd::laneVector(cloth.velocity, vertex.index);
  }
  const auto [firstIsland, lastIsland] = islandsOf(share);
  std::fill(taken_.begin() + firstIsland, taken_.begin() + lastIsland, static_cast<unsigned char>(0));
  const auto begin = static_cast<std::size_t>(own.data() - vertices_.data());
  const auto vertexOf = [](const ImpulseContact& contact) { return contact.vertices[0]; };
  const auto first = std::ranges::lower_bound(single_, begin, {}, vertexOf);
  const auto last = std::ranges::lower_bound(single_, begin + own.size(), {}, vertexOf);
  for (auto contact = first; contact != last; ++contact) {
    contact->normalImpulse = 0.0;
    contact->friction = Vec3::Zero();
    contact->minSpeed = minSpeedOf(*contact, vertices_, {time, drift});
    solveContact(*contact, vertices_);
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
      applyIsland(islands_[i], {time, drift}, cloth);
    }
  }
  // The islands of other threads, backwards, since their threads take them forwards.
  for (std::size_t i = islands_.size(); i > 0; --i) {
    if (take(i - 1)) {
      applyIsland(islands_[i - 1], {time, drift}, cloth);
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
void ContactImpulses<T>::applyIsland(ContactIsland& island, const Drift& drift, simd::SlicedCloth<T>& cloth) {
  solveIsland(island, vertices_, drift);
  for (const std::size_t v : island.vertices) {
    write(vertices_[v], drift.duration, cloth);
  }
}

/// Writes the velocity of a vertex, and the position as if the impulses had acted before the drift.
template <typename T>
void ContactImpulses<T>::write(const ContactVertex& vertex, double drift, simd::SlicedCloth<T>& cloth) {
  const Vec3 position = vertex.position + drift * (vertex.velocity - vertex.afterKick);
  simd::setLaneVector(cloth.velocity, vertex.index, vertex.velocity);
  simd::setLaneVector(cloth.position, vertex.index, position);
}

template <typename T>
void ContactImpulses<T>::addWork(const simd::StepShare& share) {
  for (ContactVertex& vertex : verticesOf(share)) {
    vertex.work += 0.5 * vertex.mass * (vertex.velocity - vertex.afterKick).dot(vertex.before + vertex.velocity);
    vertex.before = vertex.velocity;
  }
}

template <typename T>
double ContactImpulses<T>::work() const {
  double sum = 0.0;
  for (const ContactVertex& vertex : vertices_) {
    sum += vertex.work;
  }
  return sum;
}

template <typename T>
void ContactImpulses<T>::store(std::vector<SubstepContact>& contacts) const {
  for (const std::vector<ImpulseContact>* list : {&single_, &coupled_}) {
    for (const ImpulseContact& contact : *list) {
      contacts[contact.source].impulse = contact.impulse;
    }
  }
}

template class ContactImpulses<float>;
template class ContactImpulses<double>;

}  // namespace drape::sim::adaptive
