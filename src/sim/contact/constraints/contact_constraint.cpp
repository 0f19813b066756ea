#include "sim/contact/constraints/contact_constraint.hpp"

#include <algorithm>

namespace drape::sim::contact {

Vec3 pointOf(const ContactConstraint& contact, const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < contact.vertices.size(); ++c) {
    sum += contact.weights[c] * values[contact.vertices[c]];
  }
  return sum;
}

void Candidates::append(const Candidates& more) {
  contacts.insert(contacts.end(), more.contacts.begin(), more.contacts.end());
  planes.insert(planes.end(), more.planes.begin(), more.planes.end());
  overlaps += more.overlaps;
  deepestOverlap = std::max(deepestOverlap, more.deepestOverlap);
}

}  // namespace drape::sim::contact
