#include "sim/forces/external_forces.hpp"

#include "sim/forces/kernels.hpp"
#include "sim/model/normals.hpp"

namespace drape::sim {

Vec3 gravityAndAir(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                   std::size_t vertex) {
  const double mass = model.vertexMass[vertex];
  Vec3 weight(0.0, -mass * parameters.gravity, 0.0);
  if (!parameters.air.acts()) {
    return weight;
  }
  const double pressureArea = 0.5 * parameters.air.density * model.vertexArea[vertex];
  return weight + kernels::airForce(vertexNormal(model, state.positions, static_cast<int>(vertex)),
                                    state.velocities[vertex] - parameters.air.wind, pressureArea * parameters.air.drag,
                                    pressureArea * parameters.air.lift, mass, parameters.timeStep);
}

}  // namespace drape::sim
