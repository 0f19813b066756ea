#pragma once

#include "sim/model/vector.hpp"

namespace drape::sim::fabric {

/// The elastic moduli and the damping of a fabric, an orthotropic sheet whose axes are warp and weft. The moduli are
/// per width of the fabric, so they contain its thickness.
struct Material {
  double stretchWarp = 2000.0;  ///< C_11: force per width and strain along warp, with no strain along weft [N/m]
  double stretchWeft = 2000.0;  ///< C_22: the same along weft [N/m]
  double shear = 100.0;         ///< C_33: shear force per width and shear angle [N/m]
  /// Contraction across a stretch [-]: C_12 = poisson sqrt(C_11 C_22). Below 1 in size. For equal stretch moduli it is
  /// Poisson's ratio, and Young's modulus times thickness is C_11 (1 - poisson^2).
  double poisson = 0.0;

  /// Fabrics stiffen: where the strain along warp or weft exceeds `stiffeningStrain`, its slope rises by these.
  double stiffeningStrain = 0.1;  ///< Green strain [-]
  double stiffeningWarp = 0.0;    ///< [N/m]
  double stiffeningWeft = 0.0;    ///< [N/m]

  double bendWarp = 0.0;  ///< B_1: moment per width and curvature along warp [N m]
  double bendWeft = 0.0;  ///< B_2: along weft [N m]
  double bendBias = 0.0;  ///< along the direction at 45 degrees between them [N m]

  /// Damping (Kelvin and Voigt): the rate of a strain acts like a strain of the rate times this, without stiffening
  /// [s].
  double stretchDamping = 0.0;
  double bendDamping = 0.0;  ///< the same for the rate of bending [s]

  [[nodiscard]] bool stiffens() const { return stiffeningWarp > 0.0 || stiffeningWeft > 0.0; }
  [[nodiscard]] bool damps() const { return stretchDamping > 0.0 || bendDamping > 0.0; }

  friend bool operator==(const Material&, const Material&) = default;
};

/// The matrix C of the stress per width, sigma = C epsilon, with epsilon = (e_11, e_22, 2 e_12) [N/m].
[[nodiscard]] Mat3 stretchMatrix(const Material& material);

/// The matrix D of the moments per width, m = D kappa, with kappa = (k_11, k_22, 2 k_12) [N m]. The fabric does not
/// curve across a bend (D_12 = 0), as woven fabrics hardly do. Then the bending stiffness along the direction at the
/// angle phi from warp is B_1 cos^4 phi + B_2 sin^4 phi + 4 D_33 cos^2 phi sin^2 phi, so D_33 = B_bias - (B_1 + B_2)
/// / 4.
[[nodiscard]] Mat3 bendMatrix(const Material& material);

/// Whether the fabric resists bending.
[[nodiscard]] bool resistsBending(const Material& material);

/// Whether the energy is positive for every strain, and damping takes energy: C is positive definite, D is positive
/// semidefinite, and no stiffening slope or damping time is negative. False if one of them is not a finite number.
[[nodiscard]] bool isStable(const Material& material);

}  // namespace drape::sim::fabric
