#include "sim/forces/stability.hpp"

#include <cmath>
#include <limits>

namespace drape::sim {

MaterialParameters actingMaterial(const ClothModel& model, const CommonParameters& parameters) {
  return model.fabric ? MaterialParameters{.stiffness = 1.0, .damping = 0.0} : parameters.material;
}

double largestFrequency(const ClothModel& model, const CommonParameters& parameters) {
  return model.unitFrequency * std::sqrt(actingMaterial(model, parameters).stiffness);
}

double verletStepLimit(const ClothModel& model, const CommonParameters& parameters) {
  const double omega = largestFrequency(model, parameters);
  const double c = model.unitDampingRate * actingMaterial(model, parameters).damping;
  // The positive root of omega^2 h^2 + 2 c h - 4 = 0, in the form that does not cancel.
  const double denominator = c + std::sqrt(c * c + 4.0 * omega * omega);
  return denominator > 0.0 ? 4.0 / denominator : std::numeric_limits<double>::infinity();
}

}  // namespace drape::sim
