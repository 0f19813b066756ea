#pragma once

#include "sim/model/vector.hpp"

namespace drape::sim {

/// Laws of the air's force on a surface.
enum class AirModel {
  Paper,  ///< eqs. 18 to 20 of the paper
  Plate,  ///< measured forces on thin plates (kernels::plateForce)
  Auto    ///< Plate for a fabric, Paper for springs
};

/// The air around the cloth (docs/theory/method.md).
struct AirParameters {
  AirModel model = AirModel::Auto;
  double drag = 0.0;         ///< drag coefficient C_D [-]; of AirModel::Plate, for a plate that faces the wind
  double lift = 0.0;         ///< lift coefficient C_L [-]; of AirModel::Plate, the largest one, at 45 degrees
  double edgeDrag = 0.02;    ///< of AirModel::Plate, the drag coefficient of a plate along the wind [-]
  double density = 1.225;    ///< rho [kg/m^3]
  Vec3 wind = Vec3::Zero();  ///< velocity of the air [m/s]

  /// True if the air exerts a force on moving cloth.
  [[nodiscard]] bool acts() const { return drag != 0.0 || lift != 0.0; }
};

}  // namespace drape::sim
