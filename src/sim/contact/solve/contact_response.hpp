#pragma once

#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/solve/contact_solver.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Solves for the impulses of contacts with bodies, with friction: first on positions, then on velocities.
class ContactResponse {
 public:
  /// Moves the predicted positions so that they satisfy the contacts.
  /// @param positions the result [m]
  void solvePositions(const ContactPass& pass, std::span<const ContactConstraint> contacts,
                      std::vector<Vec3>& positions);

  /// Removes the velocity into the bodies at active contacts, and applies friction.
  /// @param positions at the end of the step [m]
  void solveVelocities(const ClothStep& step, const PreparedCloth& cloth, std::span<const ContactConstraint> contacts,
                       const std::vector<Vec3>& positions, std::vector<Vec3>& velocities);

  /// The active contacts of the last `solveVelocities`.
  [[nodiscard]] const std::vector<ContactConstraint>& active() const { return active_; }

 private:
  ContactSolver solver_;
  std::vector<ContactGoal> goals_;
  std::vector<ContactConstraint> active_;
};

}  // namespace drape::sim::contact
