#pragma once

#include "sim/model/vector.hpp"

#include <cstddef>
#include <utility>
#include <vector>

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

/// The material of each triangle of a cloth.
class TriangleMaterials {
 public:
  /// All triangles have the same material. Implicit, so that a cloth of one material needs no list.
  TriangleMaterials(const Material& material) : list_{material} {}  // NOLINT(google-explicit-constructor)
  /// @param list at least one  @param indices of each triangle: an index into `list`
  TriangleMaterials(std::vector<Material> list, std::vector<int> indices)
      : list_(std::move(list)), indices_(std::move(indices)) {}

  [[nodiscard]] const Material& operator[](std::size_t triangle) const { return list_[indexOf(triangle)]; }
  /// The index of a triangle's material in `list`.
  [[nodiscard]] int indexOf(std::size_t triangle) const { return indices_.empty() ? 0 : indices_[triangle]; }
  [[nodiscard]] const std::vector<Material>& list() const { return list_; }

  /// The same with each material changed. @param change called with each Material
  template <typename Change>
  [[nodiscard]] TriangleMaterials with(const Change& change) const {
    TriangleMaterials changed = *this;
    for (Material& material : changed.list_) {
      change(material);
    }
    return changed;
  }

  [[nodiscard]] bool stiffen() const;              ///< whether any of them stiffens
  [[nodiscard]] bool damp() const;                 ///< whether any of them damps
  [[nodiscard]] double maxStretchDamping() const;  ///< [s]
  [[nodiscard]] double maxBendDamping() const;     ///< [s]

  friend bool operator==(const TriangleMaterials&, const TriangleMaterials&) = default;

 private:
  std::vector<Material> list_;
  std::vector<int> indices_;  // empty: all triangles have the first material
};

/// The matrix C of the stress per width, sigma = C epsilon, with epsilon = (e_11, e_22, 2 e_12) [N/m].
[[nodiscard]] Mat3 stretchMatrix(const Material& material);

/// The matrix D of the moments per width, m = D kappa, with kappa = (k_11, k_22, 2 k_12) [N m]. The fabric does not
/// curve across a bend (D_12 = 0), as woven fabrics hardly do. Then the bending stiffness along the direction at the
/// angle phi from warp is B_1 cos^4 phi + B_2 sin^4 phi + 4 D_33 cos^2 phi sin^2 phi, so D_33 = B_bias - (B_1 + B_2)
/// / 4.
[[nodiscard]] Mat3 bendMatrix(const Material& material);

/// Whether a fabric resists bending in some of its triangles.
[[nodiscard]] bool resistBending(const TriangleMaterials& materials);

/// Whether the energy is positive for every strain, and damping takes energy: C is positive definite, D is positive
/// semidefinite, and no stiffening slope or damping time is negative. False if one of them is not a finite number.
[[nodiscard]] bool isStable(const Material& material);

}  // namespace drape::sim::fabric
