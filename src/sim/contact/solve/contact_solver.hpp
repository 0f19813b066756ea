#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"

#include <span>
#include <vector>

namespace drape {

/// What is asked of a contact: n . q must not be less than `least`, where q is the weighted sum of the vertices' values
/// (positions or velocities), and friction draws q across n towards `still`.
struct ContactGoal {
  double minNormal = 0.0;
  Vec3 sticking = Vec3::Zero();
};

/// Solves for impulses at contacts, one after the other (projected Gauss-Seidel), under Coulomb's law: what acts across
/// a contact is at most the static friction times what acts along its normal; where that does not suffice, it is the
/// kinetic friction times it, against the sliding.
class ContactSolver {
 public:
  /// Changes `values`, one a vertex.
  /// @param inverseMass one a vertex [1/kg]; 0: does not move
  void solve(std::span<const ContactConstraint> contacts, std::span<const ContactGoal> goals,
             std::span<const double> inverseMass, int iterations, std::span<Vec3> values);

 private:
  struct Impulse {
    double normal = 0.0;  // [kg times the values' unit]
    Vec3 friction = Vec3::Zero();
  };

  /// A contact with only those of its vertices that have a weight.
  struct Point {
    std::array<std::size_t, 3> vertices{};
    std::array<double, 3> weights{};
    std::array<double, 3> responses{};  // weight over mass [1/kg]
    std::size_t count = 0;
    double inverseMass = 0.0;  // inverse mass [1/kg]

    [[nodiscard]] Vec3 valueIn(std::span<const Vec3> values) const;
    void apply(const Vec3& impulse, std::span<Vec3> values) const;
  };

  void prepare(std::span<const ContactConstraint> contacts, std::span<const double> inverseMass);
  void findCoupled();
  bool solveOne(const ContactConstraint& contact, const ContactGoal& goal, std::size_t k, std::span<Vec3> values);

  std::vector<Impulse> impulses_;
  std::vector<Point> points_;
  std::vector<int> contactCount_;  // how many each vertex has
  std::vector<std::size_t>
      coupled_;  // contacts that share a vertex with others or have several: one round is not enough
};

}  // namespace drape
