#pragma once

#include "sim/vector.hpp"

#include <optional>

namespace drape {

/// What a step needs to know besides the cloth itself. Any of it may change between two steps.
struct StepParameters {
  double timeStep = 1.0 / 150.0;  ///< h [s]
  double stiffness = 100.0;       ///< k_s [N/m] of every spring
  double damping = 0.0;           ///< C_d [N s/m] of every spring
  double gravity = 9.81;          ///< acceleration downwards (-y) [m/s^2]
  double drag = 0.0;              ///< drag coefficient C_D [-]
  double lift = 0.0;              ///< lift coefficient C_L [-]
  double airDensity = 1.225;      ///< rho [kg/m^3]
  Vec3 wind = Vec3::Zero();       ///< velocity of the air [m/s]
  int sweeps = 1;                 ///< block-Jacobi sweeps a step, odd [-]
  int threads = 1;                ///< threads a step may use [-]; the result does not depend on it
};

/// A hand that holds the cloth: a spring from a point on a triangle to a target, whose force is bounded.
struct Grab {
  int triangle = 0;                 ///< index into ClothModel::triangles
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners, summing to 1
  Vec3 target = Vec3::Zero();       ///< where the hand is [m]
  double stiffness = 0.0;           ///< [N/m]
  double maxForce = 0.0;            ///< the force never exceeds this [N]
};

/// What acts on the cloth from outside during one step.
struct StepInputs {
  std::optional<Grab> grab;
};

}  // namespace drape
