#include "sim/fields/computations.hpp"

namespace drape::sim::fields {
namespace {

constexpr double millimetres = 1e3;  // in a metre

}  // namespace

void bodyGap(const FieldInputs& inputs, std::span<double> values) {
  inputs.bodies->compute(inputs.positions, values);
  for (double& value : values) {
    value *= millimetres;
  }
}

void contactPressure(const FieldInputs& inputs, std::span<double> values) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    const double area = inputs.model.vertexArea[v];
    values[v] = area > 0.0 ? inputs.contactImpulses[v] / (area * inputs.timeStep) : undefinedValue;
  }
}

void speed(const FieldInputs& inputs, std::span<double> values) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    values[v] = inputs.velocities[v].norm();
  }
}

void ghostError(const FieldInputs& inputs, std::span<double> values) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    values[v] = millimetres * (inputs.positions[v] - inputs.ghost[v]).norm();
  }
}

}  // namespace drape::sim::fields
