#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"
#include "sim/contact/inverse_mass.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The right-hand side of a contact. q is the weighted sum of the vertices' values (positions or velocities).
struct ContactGoal {
  double minNormal = 0.0;        ///< lower bound of n . q
  Vec3 sticking = Vec3::Zero();  ///< q of a contact that sticks; friction acts on q towards it, across n
};

/// Solves for contact impulses by projected Gauss-Seidel with Coulomb friction: the friction impulse that makes a
/// contact stick is at most the static coefficient times the normal impulse. If that does not suffice, the contact
/// slides, and the friction impulse is the kinetic coefficient times the normal impulse, against the slip.
///
/// One iteration solves every contact once, one after the other. A contact of one vertex that has no other contact is
/// exact after the first iteration.
class ContactSolver {
 public:
  /// Changes `values` so that they satisfy the goals.
  /// @param goals one per contact  @param inverseMass per vertex, see inverseMassOf [1/kg]; 0: the vertex does not move
  /// @param iterations at most  @param values positions [m] or velocities [m/s], one per vertex
  void solve(std::span<const ContactConstraint> contacts, std::span<const ContactGoal> goals,
             std::span<const double> inverseMass, int iterations, std::span<Vec3> values);

 private:
  struct Impulse {
    double normal = 0.0;  // [kg times the unit of the values]
    Vec3 friction = Vec3::Zero();
  };

  /// A contact, reduced to the vertices with non-zero weights.
  struct Point {
    std::array<std::size_t, 4> vertices{};
    std::array<double, 4> weights{};
    std::array<double, 4> responses{};  // weight / mass [1/kg]
    std::size_t count = 0;
    double inverseMass = 0.0;  // of the point [1/kg]

    [[nodiscard]] Vec3 valueIn(std::span<const Vec3> values) const;
    void apply(const Vec3& impulse, std::span<Vec3> values) const;
  };

  void prepare(std::span<const ContactConstraint> contacts, std::span<const double> inverseMass);
  void findCoupled();
  bool solveOne(const ContactConstraint& contact, const ContactGoal& goal, std::size_t k, std::span<Vec3> values);

  std::vector<Impulse> impulses_;
  std::vector<Point> points_;
  std::vector<int> contactCount_;     // number of contacts per vertex
  std::vector<std::size_t> coupled_;  // contacts that need several iterations: of several or shared vertices
};

}  // namespace drape::sim::contact
