#pragma once

#include "sim/model/vector.hpp"

#include <array>

namespace drape::sim {

/// A contact of the cloth, with a body or with itself, that acts in every substep of a solver: n . q >= height. q is a
/// weighted sum of up to four vertices. With a body it is a point of the cloth, and the half-space moves with the body.
/// With itself it is the offset between two points. The solver applies impulses that satisfy this, with Coulomb
/// friction: static up to the static coefficient times the normal impulse, kinetic beyond. It does not push apart what
/// starts too close.
struct SubstepContact {
  std::array<int, 4> vertices{};
  std::array<double, 4> weights{};   ///< their sum is 1 with a body, 0 with itself; 0 for unused vertices
  Vec3 normal = Vec3::UnitY();       ///< n
  double height = 0.0;               ///< at the start of the step [m]
  double restGap = 0.0;              ///< excess of n . q over the height up to which the cloth rests [m]
  Vec3 bodyVelocity = Vec3::Zero();  ///< of the body's closest point [m/s]
  double staticFriction = 0.0;       ///< [-]
  double kineticFriction = 0.0;      ///< [-]; at most the static one
  bool isFeaturePair = false;        ///< between a vertex and a triangle, or two edges, of the cloth
  Vec3 impulse = Vec3::Zero();       ///< result: impulse on q over the step [N s]

  /// Whether q is the first vertex.
  [[nodiscard]] bool isVertex() const { return weights[0] == 1.0; }
  /// Whether the cloth is in contact with a body.
  [[nodiscard]] bool isWithBody() const { return weights[0] + weights[1] + weights[2] + weights[3] > 0.5; }
};

}  // namespace drape::sim
