#include "sim/contact/solve/contact_solver.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

constexpr double converged = 1e-9;  // changes of impulses that are smaller than this share of them end the rounds [-]

}  // namespace

Vec3 TouchSolver::Point::valueIn(std::span<const Vec3> values) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < count; ++c) {
    sum += weights[c] * values[vertices[c]];
  }
  return sum;
}

void TouchSolver::Point::push(const Vec3& impulse, std::span<Vec3> values) const {
  for (std::size_t c = 0; c < count; ++c) {
    values[vertices[c]] += shares[c] * impulse;
  }
}

void TouchSolver::place(std::span<const Touch> touches, std::span<const double> inverseMass) {
  points_.clear();
  for (const Touch& touch : touches) {
    Point& point = points_.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(touch.vertices[c]);
      const double weight = touch.weights[static_cast<Eigen::Index>(c)];
      if (weight != 0.0) {
        point.vertices[point.count] = v;
        point.weights[point.count] = weight;
        point.shares[point.count] = weight * inverseMass[v];
        point.inverse += weight * weight * inverseMass[v];
        ++point.count;
      }
    }
  }
}

/// A vertex with a single touch, of itself, is where it should be after one round, exactly.
void TouchSolver::findCoupled() {
  for (const Point& point : points_) {
    for (std::size_t c = 0; c < point.count; ++c) {
      ++touchesOf_[point.vertices[c]];
    }
  }
  coupled_.clear();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (points_[k].count > 1 || touchesOf_[points_[k].vertices[0]] > 1) {
      coupled_.push_back(k);
    }
  }
}

/// @return whether the impulse changes
bool TouchSolver::solveOne(const Touch& touch, const TouchGoal& goal, std::size_t k, std::span<Vec3> values) {
  const Point& point = points_[k];
  const double inverse = point.inverse;
  if (inverse <= 0.0) {
    return false;  // nothing there can move
  }
  Impulse& impulse = impulses_[k];
  const Vec3 value = point.valueIn(values);
  const double along = std::max(0.0, impulse.along + (goal.least - touch.normal.dot(value)) / inverse);
  if (along == 0.0 && impulse.along == 0.0) {
    return false;
  }
  const Vec3 slip = value - goal.still;
  Vec3 across = impulse.across - (slip - slip.dot(touch.normal) * touch.normal) / inverse;
  const double wanted = across.norm();
  if (wanted > touch.staticFriction * along) {
    across *= touch.kineticFriction * along / wanted;
  }
  const Vec3 change = (along - impulse.along) * touch.normal + across - impulse.across;
  point.push(change, values);
  impulse = {along, across};
  return change.norm() > converged * along;
}

void TouchSolver::solve(std::span<const Touch> touches, std::span<const TouchGoal> goals,
                        std::span<const double> inverseMass, int rounds, std::span<Vec3> values) {
  impulses_.assign(touches.size(), {});
  touchesOf_.assign(values.size(), 0);
  place(touches, inverseMass);
  findCoupled();
  for (std::size_t k = 0; k < touches.size(); ++k) {
    solveOne(touches[k], goals[k], k, values);
  }
  bool changes = true;
  for (int round = 1; round < rounds && changes; ++round) {
    changes = false;
    for (const std::size_t k : coupled_) {
      changes = solveOne(touches[k], goals[k], k, values) || changes;
    }
  }
}

}  // namespace drape
