#include "sim/motion/stretching_motion.hpp"

#include "sim/forces/kernels.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim {
namespace {

double inverseMassOf(const ClothModel& model, std::size_t vertex) {
  return model.pinned[vertex] ? 0.0 : 1.0 / model.vertexMass[vertex];
}

/// The velocity changes of a sweep: to each edge of ends i, j and unit vector d the impulse g (d . (v_j - v_i)) d with
/// g = 1 / ((w_i + w_j) max(n_i, n_j)), inverse masses w and numbers of edges n. The sum of g (d . (v_j - v_i))^2 over
/// all edges is at most that of m v^2 over all vertices, so no motion is reversed.
/// @param changes of each vertex, zero at the start [m/s]  @return that sum over all edges [J]
double changesOf(const ClothModel& model, const ClothState& state, std::vector<Vec3>& changes) {
  double sum = 0.0;
  for (const Spring& edge : model.springs) {
    const auto a = static_cast<std::size_t>(edge.a);
    const auto b = static_cast<std::size_t>(edge.b);
    const double inverseMass = inverseMassOf(model, a) + inverseMassOf(model, b);
    const Vec3 offset = state.positions[b] - state.positions[a];
    const double length = offset.norm();
    if (inverseMass == 0.0 || length <= kernels::shortestLength * edge.restLength) {
      continue;
    }
    const Vec3 direction = offset / length;
    const double rate = direction.dot(state.velocities[b] - state.velocities[a]);
    const auto shared = static_cast<double>(std::max(model.springEnds[a].size(), model.springEnds[b].size()));
    const double impulse = rate / (inverseMass * shared);
    changes[a] += inverseMassOf(model, a) * impulse * direction;
    changes[b] -= inverseMassOf(model, b) * impulse * direction;
    sum += rate * impulse;
  }
  return sum;
}

}  // namespace

double removeStretchingMotion(const ClothModel& model, double energy, int sweeps, ClothState& state) {
  double removed = 0.0;
  std::vector<Vec3> changes;
  for (int sweep = 0; sweep < sweeps && removed < energy; ++sweep) {
    changes.assign(state.velocities.size(), Vec3::Zero());
    const double linear = changesOf(model, state, changes);
    double quadratic = 0.0;
    for (std::size_t v = 0; v < changes.size(); ++v) {
      quadratic += model.vertexMass[v] * changes[v].squaredNorm();
    }
    if (!(quadratic > 0.0) || !std::isfinite(linear + quadratic)) {
      break;
    }
    // A fraction f of the changes removes f linear - f^2 quadratic / 2.
    const double wanted = energy - removed;
    const double root = linear * linear - 2.0 * quadratic * wanted;
    const double fraction = root > 0.0 ? std::min(1.0, 2.0 * wanted / (linear + std::sqrt(root))) : 1.0;
    for (std::size_t v = 0; v < changes.size(); ++v) {
      state.velocities[v] += fraction * changes[v];
    }
    removed += fraction * (linear - 0.5 * fraction * quadratic);
  }
  return std::min(removed, energy);
}

}  // namespace drape::sim
