#include "sim/measures/residuals.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/systems/implicit_system.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace drape::sim {
namespace {

double relative(double squaredResidual, double squaredScale) {
  if (squaredScale > 0.0) {
    return std::sqrt(squaredResidual / squaredScale);
  }
  return squaredResidual > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

/// f(x, v) of springs, damping and attachment at `end`, of gravity and air at `start` [N].
std::vector<Vec3> forcesAtEnd(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                              const ClothState& start, const ClothState& end) {
  std::vector<Vec3> force(end.positions.size());
  for (std::size_t i = 0; i < force.size(); ++i) {
    force[i] = internalForceOn(model, parameters, end, i) + gravityAndAir(model, parameters, start, i);
  }
  if (inputs.attachment) {
    const AttachmentForce pull = attachmentForce(model, *inputs.attachment, end);
    pull.forEach([&](std::size_t v, double weight) { force[v] += weight * pull.force; });
  }
  return force;
}

}  // namespace

double nonlinearResidual(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                         const ClothState& before, const ClothState& after) {
  const double h = parameters.timeStep;
  ClothState coasting = before;
  advance(model, h, std::vector<Vec3>(before.positions.size(), Vec3::Zero()), coasting);
  const std::vector<Vec3> reached = forcesAtEnd(model, parameters, inputs, before, after);
  const std::vector<Vec3> coasted = forcesAtEnd(model, parameters, inputs, before, coasting);
  double residual = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (!model.pinned[i]) {
      const Vec3 change = model.vertexMass[i] * (after.velocities[i] - before.velocities[i]);
      residual += (change - h * reached[i]).squaredNorm();
      scale += (h * coasted[i]).squaredNorm();
    }
  }
  return relative(residual, scale);
}

}  // namespace drape::sim
