#include "sim/adaptive/contact_impulses.hpp"

#include "sim/simd/lane_vector.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace drape::sim::adaptive {
namespace {

/// Maximum number of sweeps over coupled contacts in a substep, and relative change of an impulse that counts as
/// converged.
constexpr int maxSweeps = 6;
constexpr double converged = 0.01;

/// The same for slow cloth in contact with itself. Friction that has not converged acts like a viscous force: layers on
/// each other would creep and never come to rest.
constexpr int maxSweepsOfSlow = 60;
constexpr double convergedOfSlow = 0.001;
constexpr double slowSpeed = 0.1;  // [m/s]

}  // namespace

template <typename T>
void ContactImpulses<T>::prepare(const StepInputs& inputs, const simd::SlicedCloth<T>& cloth) {
  vertices_.clear();
  single_.clear();
  coupled_.clear();
  coupledVertices_.clear();
  hasFeaturePairs_ = false;
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
  const auto& contacts = *inputs.contacts;
  hasFeaturePairs_ = std::any_of(contacts.begin(), contacts.end(), std::mem_fn(&SubstepContact::isFeaturePair));
  separateCoupled();
}

template <typename T>
void ContactImpulses<T>::addContact(const SubstepContact& from, std::size_t source, const Vec3& frameVelocity,
                                    const simd::SlicedCloth<T>& cloth) {
  Contact contact{.source = source,
                  .normal = from.normal,
                  .height = 0.0,
                  .restGap = from.restGap,
                  .staticFriction = from.staticFriction,
                  .kineticFriction = from.kineticFriction};
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
  for (const Contact& contact : coupled_) {
    for (std::size_t c = 0; c < contact.count; ++c) {
      coupledVertices_.push_back(contact.vertices[c]);
    }
  }
  std::ranges::sort(coupledVertices_);
  coupledVertices_.erase(std::unique(coupledVertices_.begin(), coupledVertices_.end()), coupledVertices_.end());
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
void ContactImpulses<T>::applyCoupled(simd::SlicedCloth<T>& cloth, double time, double drift) {
  for (Contact& contact : coupled_) {
    contact.minSpeed = minSpeedOf(cloth, time, drift, contact);
  }
  for (const Contact& contact : coupled_) {
    if (contact.normalImpulse > 0.0) {
      apply(contact.normalImpulse * contact.normal + contact.friction, contact);
    }
  }
  const bool isSlow = hasFeaturePairs_ && std::ranges::all_of(coupledVertices_, [&](std::size_t v) {
                        return vertices_[v].before.squaredNorm() < slowSpeed * slowSpeed;
                      });
  converged_ = isSlow ? convergedOfSlow : converged;
  bool changes = true;
  for (int sweep = 0; sweep < (isSlow ? maxSweepsOfSlow : maxSweeps) && changes; ++sweep) {
    changes = false;
    for (Contact& contact : coupled_) {
      changes = solve(contact) || changes;
    }
  }
  for (Contact& contact : coupled_) {
    contact.impulse += contact.normalImpulse * contact.normal + contact.friction;
  }
  for (const std::size_t v : coupledVertices_) {
    write(vertices_[v], drift, cloth);
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
  const double normal = std::max(0.0, contact.normalImpulse + (contact.minSpeed - along) / contact.inverseMass);
  if (normal == 0.0 && contact.normalImpulse == 0.0) {
    return false;
  }
  Vec3 friction = contact.friction - (relative - along * contact.normal) / contact.inverseMass;
  const double size = friction.norm();
  if (size > contact.staticFriction * normal) {
    friction *= contact.kineticFriction * normal / size;
  }
  const Vec3 change = (normal - contact.normalImpulse) * contact.normal + friction - contact.friction;
  apply(change, contact);
  contact.normalImpulse = normal;
  contact.friction = friction;
  return change.squaredNorm() > converged_ * converged_ * normal * normal;
}

template <typename T>
void ContactImpulses<T>::apply(const Vec3& impulse, const Contact& contact) {
  for (std::size_t c = 0; c < contact.count; ++c) {
    Vertex& vertex = vertices_[contact.vertices[c]];
    vertex.velocity += contact.weights[c] * vertex.inverseMass * impulse;
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
