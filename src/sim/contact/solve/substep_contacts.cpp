#include "sim/contact/solve/substep_contacts.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double marginRatio = 0.25;    // contacts are listed up to this distance beyond the predicted position
constexpr double restGapRatio = 0.002;  // distance within which a vertex rests on the surface

}  // namespace

double listMarginOf(double contactOffset, double fall) {
  return marginRatio * contactOffset + fall;
}

std::optional<SubstepContact> substepContactOf(const ContactConstraint& contact, const NearBody& body,
                                               double timeStep) {
  const auto largest = std::max_element(contact.weights.begin(), contact.weights.end());
  const auto first = static_cast<std::size_t>(largest - contact.weights.begin());
  const bool isVertex = *largest == 1.0;
  if (contact.offset <= 0.0 || (isVertex && body.mesh != nullptr &&
                                body.search->isBehindFace(body.meshInStep(false), contact.vertices[first]))) {
    return std::nullopt;
  }
  SubstepContact found{.vertices = contact.vertices,
                       .weights = contact.weights,
                       .normal = contact.normal,
                       .height = contact.height - contact.normal.dot(contact.bodyDisplacement) + contact.offset,
                       .restGap = restGapRatio * body.offsets.contactOffset,
                       .bodyVelocity = contact.bodyDisplacement / timeStep,
                       .staticFriction = contact.staticFriction,
                       .kineticFriction = contact.kineticFriction};
  if (isVertex) {
    std::swap(found.vertices[0], found.vertices[first]);
    found.weights = {1.0, 0.0, 0.0, 0.0};
  }
  return found;
}

void reportSubstepContacts(std::span<const ContactConstraint> active, std::span<const SubstepContact> contacts,
                           const ClothState& state, ContactReport& report, std::vector<ContactPoint>& points) {
  std::vector<bool> reported(state.positions.size());
  for (const ContactConstraint& contact : active) {
    for (std::size_t c = 0; c < contact.vertices.size(); ++c) {
      if (contact.weights[c] == 1.0) {
        reported[contact.vertices[c]] = true;
      }
    }
  }
  for (const SubstepContact& contact : contacts) {
    if (contact.isWithBody() && contact.isVertex() && !contact.impulse.isZero(0.0) && !reported[contact.vertices[0]]) {
      ++report.bodyContacts;
      points.push_back({state.positions[contact.vertices[0]], contact.normal});
    }
  }
}

}  // namespace drape::sim::contact
