#pragma once

#include "sim/model/vector.hpp"

namespace drape::sim {

/// The air around the cloth (docs/theory/method.md).
struct AirParameters {
  double drag = 0.0;         ///< drag coefficient C_D [-]
  double lift = 0.0;         ///< lift coefficient C_L [-]
  double density = 1.225;    ///< rho [kg/m^3]
  Vec3 wind = Vec3::Zero();  ///< velocity of the air [m/s]

  /// True if the air exerts a force on moving cloth.
  [[nodiscard]] bool acts() const { return drag != 0.0 || lift != 0.0; }
};

}  // namespace drape::sim
