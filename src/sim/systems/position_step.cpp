#include "sim/systems/position_step.hpp"

#include "sim/forces/external_forces.hpp"

namespace drape::sim {

void predictPositions(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                      Workers& workers, std::vector<Vec3>& predicted) {
  const double h = parameters.timeStep;
  predicted.resize(state.positions.size());
  workers.forEach(parameters.threads, predicted.size(), [&](std::size_t i) {
    predicted[i] = state.positions[i];
    if (!model.pinned[i]) {
      const Vec3 acceleration = gravityAndAir(model, parameters, state, i) / model.vertexMass[i];
      predicted[i] += h * (state.velocities[i] + h * acceleration);
    }
  });
}

void velocitiesFromPositions(const ClothModel& model, double timeStep, const std::vector<Vec3>& start,
                             ClothState& state) {
  for (std::size_t i = 0; i < start.size(); ++i) {
    state.velocities[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : Vec3((state.positions[i] - start[i]) / timeStep);
  }
}

}  // namespace drape::sim
