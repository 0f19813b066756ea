#include "sim/contact/solve/contact_solver.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

constexpr double converged = 1e-9;  // relative change of an impulse below which it counts as converged [-]

}  // namespace

Vec3 ContactSolver::Point::valueIn(std::span<const Vec3> values) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < count; ++c) {
    sum += weights[c] * values[vertices[c]];
  }
  return sum;
}

void ContactSolver::Point::apply(const Vec3& impulse, std::span<Vec3> values) const {
  for (std::size_t c = 0; c < count; ++c) {
    values[vertices[c]] += responses[c] * impulse;
  }
}

void ContactSolver::prepare(std::span<const ContactConstraint> contacts, std::span<const double> inverseMass) {
  points_.clear();
  for (const ContactConstraint& contact : contacts) {
    Point& point = points_.emplace_back();
    for (std::size_t c = 0; c < contact.vertices.size(); ++c) {
      const int v = contact.vertices[c];
      const double weight = contact.weights[c];
      if (weight != 0.0) {
        point.vertices[point.count] = v;
        point.weights[point.count] = weight;
        point.responses[point.count] = weight * inverseMass[v];
        point.inverseMass += weight * weight * inverseMass[v];
        ++point.count;
      }
    }
  }
}

/// Finds the contacts that need iterations. A contact of one vertex without other contacts is exact after the first.
void ContactSolver::findCoupled() {
  for (const Point& point : points_) {
    for (std::size_t c = 0; c < point.count; ++c) {
      ++contactCount_[point.vertices[c]];
    }
  }
  coupled_.clear();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (points_[k].count > 1 || contactCount_[points_[k].vertices[0]] > 1) {
      coupled_.push_back(k);
    }
  }
}

/// Solves contact k while all others keep their impulses.
/// @return whether the impulse has changed
bool ContactSolver::solveOne(const ContactConstraint& contact, const ContactGoal& goal, std::size_t k,
                             std::span<Vec3> values) {
  const Point& point = points_[k];
  const double inverseMass = point.inverseMass;
  if (inverseMass <= 0.0) {
    return false;  // all vertices are fixed
  }
  Impulse& impulse = impulses_[k];
  const Vec3 value = point.valueIn(values);
  const double normal = std::max(0.0, impulse.normal + (goal.minNormal - contact.normal.dot(value)) / inverseMass);
  if (normal == 0.0 && impulse.normal == 0.0) {
    return false;
  }
  const Vec3 slip = value - goal.sticking;
  Vec3 friction = impulse.friction - (slip - slip.dot(contact.normal) * contact.normal) / inverseMass;
  const double size = friction.norm();
  if (size > contact.staticFriction * normal) {
    friction *= contact.kineticFriction * normal / size;
  }
  const Vec3 change = (normal - impulse.normal) * contact.normal + friction - impulse.friction;
  point.apply(change, values);
  impulse = {normal, friction};
  return change.norm() > converged * normal;
}

void ContactSolver::solve(std::span<const ContactConstraint> contacts, std::span<const ContactGoal> goals,
                          std::span<const double> inverseMass, int iterations, std::span<Vec3> values) {
  impulses_.assign(contacts.size(), {});
  contactCount_.assign(values.size(), 0);
  prepare(contacts, inverseMass);
  findCoupled();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    solveOne(contacts[k], goals[k], k, values);
  }
  bool changes = true;
  for (int iteration = 1; iteration < iterations && changes; ++iteration) {
    changes = false;
    for (const std::size_t k : coupled_) {
      changes = solveOne(contacts[k], goals[k], k, values) || changes;
    }
  }
}

}  // namespace drape::sim::contact
