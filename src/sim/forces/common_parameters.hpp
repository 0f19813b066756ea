#pragma once

#include "sim/forces/air_parameters.hpp"
#include "sim/forces/material_parameters.hpp"
#include "sim/model/force_derivative.hpp"

namespace drape::sim {

/// The precision of a step's arithmetic. States are always stored in double.
enum class Precision { Float, Double };

/// The parameters of a step that all methods share. Any of them may change between two steps.
struct CommonParameters {
  double timeStep = 1.0 / 150.0;  ///< h [s]
  double gravity = 9.81;          ///< acceleration downwards (-y) [m/s^2]
  MaterialParameters material;
  AirParameters air;
  ForceDerivative derivative = ForceDerivative::Stabilised;  ///< of all implicit methods
  Precision precision = Precision::Double;                   ///< of methods that support both
  int threads = 1;  ///< threads a step may use [-]; the result does not depend on it
};

}  // namespace drape::sim
