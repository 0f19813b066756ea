#include "sim/contact/touch_solver.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

constexpr double converged = 1e-9;  // changes of impulses that are smaller than this share of them end the rounds [-]

Vec3 valueAt(const Touch& touch, std::span<const Vec3> values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    sum += touch.weights[static_cast<Eigen::Index>(c)] * values[static_cast<std::size_t>(touch.vertices[c])];
  }
  return sum;
}

void push(const Touch& touch, const Vec3& impulse, std::span<const double> inverseMass, std::span<Vec3> values) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(touch.vertices[c]);
    values[v] += touch.weights[static_cast<Eigen::Index>(c)] * inverseMass[v] * impulse;
  }
}

double inverseMassAt(const Touch& touch, std::span<const double> inverseMass) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double weight = touch.weights[static_cast<Eigen::Index>(c)];
    sum += weight * weight * inverseMass[static_cast<std::size_t>(touch.vertices[c])];
  }
  return sum;
}

}  // namespace

void TouchSolver::solve(std::span<const Touch> touches, std::span<const TouchGoal> goals,
                        std::span<const double> inverseMass, int rounds, std::span<Vec3> values) {
  impulses_.assign(touches.size(), {});
  bool changes = true;
  for (int round = 0; round < rounds && changes; ++round) {
    changes = false;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const Touch& touch = touches[k];
      const double inverse = inverseMassAt(touch, inverseMass);
      if (inverse <= 0.0) {
        continue;  // nothing there can move
      }
      Impulse& impulse = impulses_[k];
      const Vec3 value = valueAt(touch, values);
      const double along = std::max(0.0, impulse.along + (goals[k].least - touch.normal.dot(value)) / inverse);
      if (along == 0.0 && impulse.along == 0.0) {
        continue;
      }
      const Vec3 slip = value - goals[k].still;
      Vec3 across = impulse.across - (slip - slip.dot(touch.normal) * touch.normal) / inverse;
      const double wanted = across.norm();
      if (wanted > touch.staticFriction * along) {
        across *= touch.kineticFriction * along / wanted;
      }
      const Vec3 change = (along - impulse.along) * touch.normal + across - impulse.across;
      changes = changes || change.norm() > converged * along;
      push(touch, change, inverseMass, values);
      impulse = {along, across};
    }
  }
}

}  // namespace drape
