#include "sim/adaptive/contact_impulses.hpp"

#include <algorithm>
#include <iterator>

namespace drape::sim::adaptive {
namespace {

template <typename T>
Vec3 laneVector(const simd::LaneVectors<T>& vectors, int index) {
  return {static_cast<double>(vectors.x.data()[index]), static_cast<double>(vectors.y.data()[index]),
          static_cast<double>(vectors.z.data()[index])};
}

template <typename T>
void setLaneVector(simd::LaneVectors<T>& vectors, int index, const Vec3& value) {
  vectors.set(static_cast<std::size_t>(index), static_cast<T>(value.x()), static_cast<T>(value.y()),
              static_cast<T>(value.z()));
}

/// Maximum number of sweeps over coupled contacts in a substep, and relative change of an impulse that counts as
/// converged.
constexpr int maxSweeps = 6;
constexpr double converged = 0.01;

}  // namespace

template <typename T>
void ContactImpulses<T>::prepare(const StepInputs& inputs, const simd::SlicedCloth<T>& cloth) {
  vertices_.clear();
  single_.clear();
  coupled_.clear();
  source_ = inputs.contacts;
  if (source_ == nullptr) {
    return;
  }
  const auto lanes = static_cast<std::size_t>(cloth.layout.slices()) * simd::sliceLanes;
  slots_.assign(lanes, 0);
  for (const SubstepContact& contact : *source_) {
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
  for (std::size_t i = 0; i < source_->size(); ++i) {
    addContact(i, inputs.frameVelocity, cloth);
  }
  separateCoupled();
}

template <typename T>
void ContactImpulses<T>::addContact(std::size_t source, const Vec3& frameVelocity, const simd::SlicedCloth<T>& cloth) {
  const SubstepContact& from = (*source_)[source];
  Contact contact{.source = source};
  double total = 0.0;
  for (std::size_t c = 0; c < from.weights.size(); ++c) {
    const double weight = from.weights[c];
    if (weight != 0.0) {
      const std::size_t slot = slots_[cloth.layout.indexOf[from.vertices[c]]];
      contact.vertices[contact.count] = slot;
      contact.weights[contact.count++] = weight;
      contact.inverseMass += weight * weight * vertices_[slot].inverseMass;
      total += weight;
    }
  }
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

template <typename T>
std::span<typename ContactImpulses<T>::Vertex> ContactImpulses<T>::verticesOf(const simd::StepShare& share) {
  const auto first = std::ranges::lower_bound(vertices_, share.begin * simd::sliceLanes, {}, &Vertex::index);
  const auto last = std::ranges::lower_bound(vertices_, share.end * simd::sliceLanes, {}, &Vertex::index);
  return {first, last};
}

template <typename T>
void ContactImpulses<T>::start(const simd::SlicedCloth<T>& cloth, const simd::StepShare& share) {
  for (Vertex& vertex : verticesOf(share)) {
    vertex.before = laneVector(cloth.velocity, vertex.index);
  }
}

template <typename T>
void ContactImpulses<T>::applySingle(simd::SlicedCloth<T>& cloth, double time, double drift,
                                     const simd::StepShare& share) {
  const std::span<Vertex> own = verticesOf(share);
  for (Vertex& vertex : own) {
    vertex.afterKick = laneVector(cloth.velocity, vertex.index);
  }
  const auto begin = static_cast<std::size_t>(own.data() - vertices_.data());
  const auto vertexOf = [](const Contact& contact) { return contact.vertices[0]; };
  const auto first = std::ranges::lower_bound(single_, begin, {}, vertexOf);
  const auto last = std::ranges::lower_bound(single_, begin + own.size(), {}, vertexOf);
  for (auto contact = first; contact != last; ++contact) {
    contact->normalImpulse = 0.0;
    contact->friction = Vec3::Zero();
    solve(cloth, time, drift, *contact);
    contact->impulse += contact->normalImpulse * (*source_)[contact->source].normal + contact->friction;
  }
}

template <typename T>
void ContactImpulses<T>::applyCoupled(simd::SlicedCloth<T>& cloth, double time, double drift) {
  for (const Contact& contact : coupled_) {
    if (contact.normalImpulse > 0.0) {
      apply(contact.normalImpulse * (*source_)[contact.source].normal + contact.friction, drift, contact, cloth);
    }
  }
  bool changes = true;
  for (int sweep = 0; sweep < maxSweeps && changes; ++sweep) {
    changes = false;
    for (Contact& contact : coupled_) {
      changes = solve(cloth, time, drift, contact) || changes;
    }
  }
  for (Contact& contact : coupled_) {
    contact.impulse += contact.normalImpulse * (*source_)[contact.source].normal + contact.friction;
  }
}

/// Changes the impulse of a contact in a substep so that the contact is satisfied.
/// @return whether the impulse has changed noticeably
template <typename T>
bool ContactImpulses<T>::solve(simd::SlicedCloth<T>& cloth, double time, double drift, Contact& contact) {
  const SubstepContact& from = (*source_)[contact.source];
  Vec3 relative = -contact.bodyVelocity;
  double gapAtEnd = -from.height - contact.normalSpeed * time;
  for (std::size_t c = 0; c < contact.count; ++c) {
    const int index = vertices_[contact.vertices[c]].index;
    relative += contact.weights[c] * laneVector(cloth.velocity, index);
    gapAtEnd += contact.weights[c] * from.normal.dot(laneVector(cloth.position, index));
  }
  const double along = from.normal.dot(relative);
  const double gap = gapAtEnd - drift * along;
  const double minSpeed = gap > from.restGap ? -gap / drift : 0.0;
  const double normal = std::max(0.0, contact.normalImpulse + (minSpeed - along) / contact.inverseMass);
  if (normal == 0.0 && contact.normalImpulse == 0.0) {
    return false;
  }
  Vec3 friction = contact.friction - (relative - along * from.normal) / contact.inverseMass;
  const double size = friction.norm();
  if (size > from.staticFriction * normal) {
    friction *= from.kineticFriction * normal / size;
  }
  const Vec3 change = (normal - contact.normalImpulse) * from.normal + friction - contact.friction;
  apply(change, drift, contact, cloth);
  contact.normalImpulse = normal;
  contact.friction = friction;
  return change.squaredNorm() > converged * converged * normal * normal;
}

template <typename T>
void ContactImpulses<T>::apply(const Vec3& impulse, double drift, const Contact& contact,
                               simd::SlicedCloth<T>& cloth) const {
  for (std::size_t c = 0; c < contact.count; ++c) {
    const Vertex& vertex = vertices_[contact.vertices[c]];
    const Vec3 change = contact.weights[c] * vertex.inverseMass * impulse;
    setLaneVector(cloth.velocity, vertex.index, Vec3(laneVector(cloth.velocity, vertex.index) + change));
    setLaneVector(cloth.position, vertex.index, Vec3(laneVector(cloth.position, vertex.index) + drift * change));
  }
}

template <typename T>
void ContactImpulses<T>::addWork(const simd::SlicedCloth<T>& cloth, const simd::StepShare& share) {
  for (Vertex& vertex : verticesOf(share)) {
    const Vec3 velocity = laneVector(cloth.velocity, vertex.index);
    vertex.work += 0.5 * vertex.mass * (velocity - vertex.afterKick).dot(vertex.before + velocity);
    vertex.before = velocity;
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
