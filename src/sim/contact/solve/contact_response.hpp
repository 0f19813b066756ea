#pragma once

#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/solve/contact_solver.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Solves for the impulses of contacts with bodies, with friction (ContactSolver): first on positions, then on
/// velocities (as in Bridson, Fedkiw and Anderson 2002, Robust treatment of collisions, contact and friction for cloth
/// animation).
class ContactResponse {
 public:
  /// Moves the predicted positions so that they satisfy the contacts. A contact that sticks moves along with the body's
  /// surface from its start.
  /// @param positions the result: solved positions [m]
  void solvePositions(const ContactPass& pass, std::span<const ContactConstraint> contacts,
                      std::vector<Vec3>& positions);

  /// Removes the velocity into the bodies at active contacts, and applies friction against the velocity of the body's
  /// surface. A contact is active if its point ends near its required distance.
  /// @param positions at the end of the step [m]  @param velocities changed [m/s]
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
