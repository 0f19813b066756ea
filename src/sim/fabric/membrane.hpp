#pragma once

#include "sim/fabric/material.hpp"
#include "sim/fabric/rest_shape.hpp"
#include "sim/model/force_derivative.hpp"

#include <span>

namespace drape::sim::fabric {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// The positions of a triangle's corners [m], one a column.
using Corners = Mat3;

/// The corners of a triangle.
[[nodiscard]] Corners cornersOf(const Triangle& triangle, std::span<const Vec3> positions);

/// The membrane of one triangle: Saint Venant-Kirchhoff, orthotropic, with Green's strain.
///
/// | symbol  | meaning                                                                         | unit |
/// |---------|---------------------------------------------------------------------------------|------|
/// | X_e     | side e at rest, in coordinates along warp and weft                              | m    |
/// | x_e     | side e now                                                                      | m    |
/// | q_e     | (|x_e|^2 - |X_e|^2) / 2 = X_e^T E X_e with Green's strain E                      | m^2  |
/// | epsilon | (E_11, E_22, 2 E_12) = M^-1 q; the rows of M are (X_1^2, X_2^2, X_1 X_2)          | -    |
/// | sigma   | C epsilon, plus the stiffening                                                  | N/m  |
/// | t_e     | tension of a side, A M^-T sigma; it pulls the ends together by t_e x_e           | N/m  |
///
/// The tensions need neither a root nor a division, and the sum over the triangles of an edge has the form of a spring.
/// For one modulus and no stiffening it is Delingette's biquadratic spring (2008, Triangular springs for modelling
/// nonlinear membranes).
///
/// Under compression the tension is negative as in linear elasticity, and cloth that is free to move buckles instead.
/// The energy of a triangle that collapses to a point is finite. A triangle has no inside and outside, so it can turn
/// over without energy.
class MembraneTriangle {
 public:
  MembraneTriangle() = default;
  /// A degenerate triangle has no stiffness. @param stiffnessScale factor on all of its moduli [-]
  MembraneTriangle(const RestTriangle& rest, const Material& material, double stiffnessScale = 1.0);

  /// q of the three sides [m^2].
  [[nodiscard]] Vec3 excess(const Corners& corners) const;
  /// Green's strain (E_11, E_22, 2 E_12) [-]. @param excess q of the three sides [m^2]
  [[nodiscard]] Vec3 strain(const Vec3& excess) const { return strainOfSides_ * excess; }
  /// The energy [J].
  [[nodiscard]] double energy(const Vec3& excess) const;
  [[nodiscard]] double energy(const Corners& corners) const { return energy(excess(corners)); }
  /// The tensions t_e of the sides [N/m].
  [[nodiscard]] Vec3 tensions(const Vec3& excess) const;
  [[nodiscard]] Vec3 tensions(const Corners& corners) const { return tensions(excess(corners)); }
  /// The tensions of the stress without its compressive principal parts [N/m].
  [[nodiscard]] Vec3 tensileTensions(const Vec3& excess) const;
  /// The derivative of the tensions by q, positive semidefinite [N/m^3].
  [[nodiscard]] Mat3 tangentOfSides(const Vec3& excess) const;
  /// The second derivative of the energy by the corners' positions, in order [N/m].
  ///
  /// | variant     | geometric part, which the stress causes                                              |
  /// |-------------|--------------------------------------------------------------------------------------|
  /// | Exact       | of the whole stress; the matrix is indefinite under compression                       |
  /// | Stabilised  | of the stress without its compressive principal parts: semidefinite, exact in tension |
  /// | Axial       | none: semidefinite                                                                   |
  /// | TensionOnly | as Stabilised; without the elastic part too if no principal stress is tensile        |
  /// | Scalar      | the largest stiffness of the sides, in all directions                                |
  ///
  /// Stabilised is the counterpart of the paper's eq. 16, which leaves out the same part for a compressed spring.
  [[nodiscard]] Mat9 derivative(const Corners& corners, ForceDerivative variant) const;

  /// K of t = K q without stiffening, one row a side [N/m^3].
  [[nodiscard]] Mat3 stiffnessOfSides() const;

  /// The stiffening in one direction: with s = max(0, weights.q - start), its energy is s^2 / 2 and its tensions s
  /// weights.
  struct Stiffening {
    Vec3 weights;        ///< of the sides [sqrt(N m) / m^2]
    double start = 0.0;  ///< [sqrt(N m)]
  };
  /// @param direction 0: warp, 1: weft
  [[nodiscard]] Stiffening stiffeningOfSides(std::size_t direction) const;

 private:
  [[nodiscard]] Vec3 stress(const Vec3& strain) const;
  [[nodiscard]] Mat3 tangent(const Vec3& strain) const;

  Mat3 strainOfSides_ = Mat3::Zero();  // M^-1 [1/m^2]
  Vec3 restSquares_ = Vec3::Zero();    // |X_e|^2 [m^2]
  Mat3 stretch_ = Mat3::Zero();        // C [N/m]
  Vec2 stiffening_ = Vec2::Zero();     // [N/m]
  double stiffeningStrain_ = 0.0;      // [-]
  double area_ = 0.0;                  // A [m^2]
};

}  // namespace drape::sim::fabric
