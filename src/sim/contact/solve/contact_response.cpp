#include "sim/contact/solve/contact_response.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr int positionIterations = 6;
constexpr int velocityIterations = 6;
constexpr double nearRatio = 0.1;  // a contact is active up to this excess over its required distance, over that [-]

}  // namespace

void ContactResponse::solvePositions(const ContactPass& pass, std::span<const ContactConstraint> contacts,
                                     std::vector<Vec3>& positions) {
  goals_.clear();
  for (const ContactConstraint& contact : contacts) {
    goals_.push_back({contact.height + contact.offset, pointOf(contact, pass.step.start) + contact.bodyDisplacement});
  }
  positions = pass.step.predicted;
  solver_.solve(contacts, goals_, pass.cloth.inverseMass, positionIterations, positions);
}

void ContactResponse::solveVelocities(const ClothStep& step, const PreparedCloth& cloth,
                                      std::span<const ContactConstraint> contacts, const std::vector<Vec3>& positions,
                                      std::vector<Vec3>& velocities) {
  const double h = step.parameters.timeStep;
  active_.clear();
  goals_.clear();
  for (const ContactConstraint& contact : contacts) {
    const double excess = contact.normal.dot(pointOf(contact, positions)) - contact.height - contact.offset;
    if (excess < nearRatio * contact.offset || contact.offset <= 0.0) {
      const Vec3 bodyVelocity = contact.bodyDisplacement / h;
      active_.push_back(contact);
      goals_.push_back({contact.normal.dot(bodyVelocity) - std::max(0.0, excess) / h, bodyVelocity});
    }
  }
  solver_.solve(active_, goals_, cloth.inverseMass, velocityIterations, velocities);
}

}  // namespace drape::sim::contact
