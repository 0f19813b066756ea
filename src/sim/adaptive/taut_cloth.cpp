#include "sim/adaptive/taut_cloth.hpp"

#include "sim/adaptive/tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace drape::sim::adaptive {
namespace {

/// The positions of the aggregates of a level: the mass-weighted means of their members.
std::vector<Vec3> aggregatePositions(const CoarseLevel& level, const ClothModel& finer,
                                     const std::vector<Vec3>& positions) {
  std::vector<Vec3> means(level.cloth->restPositions.size(), Vec3::Zero());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto aggregate = static_cast<std::size_t>(level.aggregateOf[i]);
    means[aggregate] += finer.vertexMass[i] / level.cloth->vertexMass[aggregate] * positions[i];
  }
  return means;
}

/// A coarse cloth whose springs resist stretching only, under a uniform load.
class Relaxation {
 public:
  /// @param stiffness of the springs [N/m]  @param load force on a mass [m/s^2]
  Relaxation(const ClothModel& cloth, std::vector<Vec3> positions, double stiffness, Vec3 load)
      : cloth_(cloth),
        start_(positions),
        positions_(std::move(positions)),
        stiffness_(stiffness),
        load_(std::move(load)) {
    velocities_.assign(positions_.size(), Vec3::Zero());
    forces_.resize(positions_.size());
  }

  /// The mean distance from the start once the cloth is at rest, or more than `largest` as soon as it is [m].
  double reach(double largest) {
    constexpr int maxSteps = 2000;
    constexpr int enoughPeaks = 4;
    double kinetic = 0.0;
    double distance = 0.0;
    for (int step = 0, peaks = 0; step < maxSteps && peaks < enoughPeaks && distance <= largest; ++step) {
      const double before = kinetic;
      kinetic = move();
      if (kinetic < before) {
        // The kinetic energy was at its peak, so the cloth is near its equilibrium.
        velocities_.assign(velocities_.size(), Vec3::Zero());
        kinetic = 0.0;
        ++peaks;
      }
      distance = meanDistance();
    }
    return distance;
  }

 private:
  /// A step of unit time with masses for which it is stable. @return twice the kinetic energy, in these units
  double move() {
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      forces_[i] = cloth_.vertexMass[i] * load_;
    }
    for (const Spring& spring : cloth_.springs) {
      const auto a = static_cast<std::size_t>(spring.a);
      const auto b = static_cast<std::size_t>(spring.b);
      const Vec3 offset = positions_[b] - positions_[a];
      const double length = offset.norm();
      if (length > spring.restLength) {
        const Vec3 force = stiffness_ * (1.0 - spring.restLength / length) * offset;
        forces_[a] += force;
        forces_[b] -= force;
      }
    }
    double kinetic = 0.0;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (!cloth_.pinned[i] && !cloth_.springEnds[i].empty()) {
        const double mass = stiffness_ * static_cast<double>(cloth_.springEnds[i].size());
        velocities_[i] += forces_[i] / mass;
        positions_[i] += velocities_[i];
        kinetic += mass * velocities_[i].squaredNorm();
      }
    }
    return kinetic;
  }

  [[nodiscard]] double meanDistance() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      sum += (positions_[i] - start_[i]).norm();
    }
    return sum / static_cast<double>(positions_.size());
  }

  const ClothModel& cloth_;
  std::vector<Vec3> start_;
  std::vector<Vec3> positions_;
  std::vector<Vec3> velocities_;
  std::vector<Vec3> forces_;
  double stiffness_;
  Vec3 load_;
};

/// Four directions that are evenly distributed: the corners of a tetrahedron, one of them downwards.
std::array<Vec3, 4> directions() {
  const double across = std::sqrt(8.0) / 3.0;
  const double side = std::sqrt(0.75) * across;
  return {Vec3(0.0, -1.0, 0.0), Vec3(across, 1.0 / 3.0, 0.0), Vec3(-0.5 * across, 1.0 / 3.0, side),
          Vec3(-0.5 * across, 1.0 / 3.0, -side)};
}

}  // namespace

bool isTaut(const ClothModel& model, const std::vector<CoarseLevel>& levels, const CommonParameters& parameters,
            const std::vector<Vec3>& positions) {
  if (parameters.gravity == 0.0 || std::none_of(model.pinned.begin(), model.pinned.end(), std::identity())) {
    return false;
  }
  const ClothModel* cloth = &model;
  std::vector<Vec3> start = positions;
  for (const CoarseLevel& level : levels) {
    if (cloth->vertexCount() <= tuning.maxAggregatesOfTautCloth) {
      break;
    }
    start = aggregatePositions(level, *cloth, start);
    cloth = level.cloth.get();
  }
  const double diagonal = diagonalOf(model);
  const double weight = parameters.gravity * model.totalMass();
  const double stiffness = std::min(parameters.material.stiffness, tuning.tautStiffness * weight / diagonal);
  const double largest = tuning.tautReach * diagonal;
  const auto holds = [&](const Vec3& direction) {
    return Relaxation(*cloth, start, stiffness, parameters.gravity * direction).reach(largest) <= largest;
  };
  const auto loads = directions();
  return std::all_of(loads.begin(), loads.end(), holds);
}

}  // namespace drape::sim::adaptive
