#include "sim/external_forces.hpp"

#include "sim/kernels.hpp"
#include "sim/normals.hpp"

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

AttachmentForce attachmentForce(const ClothModel& model, const Attachment& attachment, const ClothState& state) {
  AttachmentForce pull;
  pull.weights = attachment.barycentric;
  Vec3 point = Vec3::Zero();
  const Triangle& corners = model.triangles[static_cast<std::size_t>(attachment.triangle)];
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(corners[c]);
    const double weight = attachment.barycentric[static_cast<Eigen::Index>(c)];
    pull.vertices[c] = v;
    point += weight * state.positions[v];
    pull.velocity += weight * state.velocities[v];
  }
  const Vec3 offset = attachment.target - point;
  const double distance = offset.norm();
  pull.force = kernels::boundedSpringForce(offset, attachment.stiffness, attachment.maxForce);
  pull.stiffness = distance > 0.0 ? pull.force.norm() / distance : attachment.stiffness;
  return pull;
}

}  // namespace drape
