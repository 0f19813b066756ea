#include "sim/forces/external_forces.hpp"

#include "sim/model/normals.hpp"

#include <algorithm>

namespace drape::sim {

bool actsAsPlate(const ClothModel& model, const AirParameters& air) {
  return air.model == AirModel::Plate || (air.model == AirModel::Auto && model.fabric != nullptr);
}

kernels::AirFactors airFactorsOf(const AirParameters& air, double area) {
  const double pressureArea = 0.5 * air.density * area;
  return {.drag = pressureArea * air.drag,
          .lift = pressureArea * air.lift,
          .edgeDrag = pressureArea * std::min(air.edgeDrag, air.drag)};
}

Vec3 gravityAndAir(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                   std::size_t vertex) {
  const double mass = model.vertexMass[vertex];
  Vec3 weight(0.0, -mass * parameters.gravity, 0.0);
  if (!parameters.air.acts()) {
    return weight;
  }
  return weight + kernels::airForce(vertexNormal(model, state.positions, static_cast<int>(vertex)),
                                    state.velocities[vertex] - parameters.air.wind,
                                    airFactorsOf(parameters.air, model.vertexArea[vertex]),
                                    actsAsPlate(model, parameters.air), mass, parameters.timeStep);
}

}  // namespace drape::sim
