#include "sim/forces/diagnostics.hpp"

#include "sim/fabric/fabric.hpp"

#include <algorithm>
#include <numeric>

namespace drape::sim {

double kineticEnergy(const ClothModel& model, const ClothState& state) {
  double energy = 0.0;
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    energy += 0.5 * model.vertexMass[v] * state.velocities[v].squaredNorm();
  }
  return energy;
}

Energy energyOf(const ClothModel& model, const CommonParameters& parameters, const ClothState& state) {
  Energy energy{.kinetic = kineticEnergy(model, state)};
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    energy.potential +=
        model.vertexMass[v] * parameters.gravity * (state.positions[v].y() - model.restPositions[v].y());
  }
  if (model.fabric) {
    energy.elastic = fabric::elasticEnergy(model, state.positions);
    return energy;
  }
  for (const Spring& spring : model.springs) {
    const double length = (state.positions[spring.b] - state.positions[spring.a]).norm();
    const double elongation = length - spring.restLength;
    energy.elastic += 0.5 * parameters.material.stiffness * spring.relativeStiffness * elongation * elongation;
  }
  return energy;
}

double maxStretch(const ClothModel& model, const ClothState& state) {
  double largest = 0.0;
  for (const Spring& spring : model.springs) {
    if (spring.restLength > 0.0) {
      const double length = (state.positions[spring.b] - state.positions[spring.a]).norm();
      largest = std::max(largest, (length - spring.restLength) / spring.restLength);
    }
  }
  return largest;
}

double strainOfTightest(const ClothModel& model, std::span<const Vec3> positions) {
  std::vector<double> strains;
  strains.reserve(model.springs.size());
  for (const Spring& spring : model.springs) {
    const double length = (positions[spring.b] - positions[spring.a]).norm();
    strains.push_back(spring.restLength > 0.0 ? length / spring.restLength - 1.0 : 0.0);
  }
  if (strains.empty()) {
    return 0.0;
  }
  const auto place = strains.begin() + static_cast<std::ptrdiff_t>(strains.size() - 1 - strains.size() / 20);
  std::ranges::nth_element(strains, place);
  return *place;
}

double meanEdge(const ClothModel& model) {
  if (model.springs.empty()) {
    return 0.0;
  }
  const double sum = std::accumulate(model.springs.begin(), model.springs.end(), 0.0,
                                     [](double length, const Spring& spring) { return length + spring.restLength; });
  return sum / static_cast<double>(model.springs.size());
}

}  // namespace drape::sim
