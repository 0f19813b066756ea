#include "sim/contact/solve/remove_approach.hpp"

#include <algorithm>
#include <limits>

namespace drape::sim::contact {

void removeApproach(const std::vector<Vec3>& before, const std::function<Vec3(std::size_t vertex)>& obstacleVelocity,
                    std::optional<double> spread, ClothState& state) {
  for (std::size_t v = 0; v < before.size(); ++v) {
    const Vec3 moved = state.positions[v] - before[v];
    const double distance = moved.norm();
    if (distance > 0.0) {
      const Vec3 normal = moved / distance;
      const double approach = -normal.dot(state.velocities[v] - obstacleVelocity(v));
      const double limit = spread ? distance / *spread : std::numeric_limits<double>::infinity();
      state.velocities[v] += std::clamp(approach, 0.0, limit) * normal;
    }
  }
}

void limitApproach(const std::vector<Vec3>& before, const std::vector<Vec3>& start, double timeStep,
                   ClothState& state) {
  for (std::size_t v = 0; v < before.size(); ++v) {
    const Vec3 moved = state.positions[v] - before[v];
    const double distance = moved.norm();
    if (distance > 0.0) {
      const Vec3 normal = moved / distance;
      const double limit = std::max(0.0, -normal.dot(state.positions[v] - start[v]) / timeStep);
      state.velocities[v] += std::max(0.0, -normal.dot(state.velocities[v]) - limit) * normal;
    }
  }
}

}  // namespace drape::sim::contact
