#include "sim/forces/external_forces.hpp"

#include "sim/forces/kernels.hpp"
#include "sim/model/normals.hpp"

namespace drape {

Vec3 gravityAndAir(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                   std::size_t vertex) {
  const double mass = model.vertexMass[vertex];
  Vec3 weight(0.0, -mass * parameters.gravity, 0.0);
  if (parameters.drag == 0.0 && parameters.lift == 0.0) {
    return weight;
  }
  const double pressureArea = 0.5 * parameters.airDensity * model.vertexArea[vertex];
  return weight + kernels::airForce(vertexNormal(model, state.positions, static_cast<int>(vertex)),
                                    state.velocities[vertex] - parameters.wind, pressureArea * parameters.drag,
                                    pressureArea * parameters.lift, mass, parameters.timeStep);
}

}  // namespace drape
