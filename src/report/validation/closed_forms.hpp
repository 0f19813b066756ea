#pragma once

#include "sim/fabric/material.hpp"

/// Closed forms of the mechanics of sheets, which the validation cases compare with. None of them shares code with the
/// simulation.
namespace drape::report::validation {

/// The tip of a strip that is clamped horizontally, in units of its length.
struct ElasticaTip {
  double along = 0.0;  ///< horizontal distance from the clamp [-]
  double down = 0.0;   ///< drop below the clamp [-]

  /// The angle of the chord from clamp to tip below the horizontal [rad].
  [[nodiscard]] double chordAngle() const;
};

/// The heavy elastica: an inextensible strip of length 1, clamped horizontally at s = 0, bends under its own weight,
///
///     theta'' = -Gamma (1 - s) cos(theta),   theta(0) = 0,   theta'(1) = 0
///
/// with theta the slope below the horizontal. Gamma = w L^3 / B, with the weight w per area [N/m^2], the length L [m]
/// and the bending stiffness B per width [N m]. For small Gamma the drop is Gamma / 8. Solved by shooting
/// from the tip. @param gamma above 0 and at most 400
[[nodiscard]] ElasticaTip heavyElasticaTip(double gamma);

/// The Gamma at which the chord of the heavy elastica makes this angle with the horizontal. @param angle [rad], above
/// 0 and at most 1.4
[[nodiscard]] double gammaOfChordAngle(double angle);

/// The angle of Peirce's cantilever test, 41.5 degrees [rad].
inline constexpr double peirceAngle = 41.5 / 180.0 * 3.14159265358979323846;

/// The bending length c = (B / w)^(1/3) [m]. @param bending B [N m]  @param weight w per area [N/m^2]
[[nodiscard]] double bendingLength(double bending, double weight);

/// The overhang [m] at which the chord of a strip makes the angle peirceAngle, from the heavy elastica.
[[nodiscard]] double peirceOverhang(double bending, double weight);

/// Peirce's own approximation of the bending length, c = L (cos(theta / 2) / (8 tan(theta)))^(1/3) [m]. At 41.5 degrees
/// it is close to L / 2. (Peirce 1930, The "handle" of cloth as a measurable quantity.)
/// @param overhang L [m]  @param angle theta [rad]
[[nodiscard]] double peirceFormula(double overhang, double angle);

/// The stretch lambda of a strip under a force per width at rest f, where Saint Venant-Kirchhoff's law is E h lambda
/// (lambda^2 - 1) / 2 = f [-]. @param force f [N/m], not negative  @param modulus E h [N/m]
[[nodiscard]] double stretchUnderLoad(double force, double modulus);

/// The stretch across such a strip, whose sides are free [-].
[[nodiscard]] double stretchAcross(double stretch, double poisson);

/// The elongation of a strip that hangs from one end under its own weight [m], with the same law.
/// @param weight per area at rest [N/m^2]  @param length at rest [m]  @param modulus E h [N/m]
[[nodiscard]] double elongationByWeight(double weight, double length, double modulus);

/// The sag of an inextensible chain between two supports of the same height [m]. @param length [m], above `span`
/// @param span distance of the supports [m]
[[nodiscard]] double catenarySag(double length, double span);

/// Euler's buckling load of a strip with hinged ends, pi^2 B / L^2 a width [N/m].
[[nodiscard]] double bucklingLoad(double bending, double length);

/// Lateral buckling of a strip on edge: one end of it is clamped, its width is vertical, and it buckles sideways under
/// its own weight. The strip is inextensible, deflects by v + z theta with z the height over its middle line, and its
/// bending moment in its own plane is q (L - x)^2 / 2. The energy of a small deflection is
///
///     1/2 integral of  B v''^2 + q (L - x)^2 v'' theta + C theta'^2 + W theta''^2  over the length L
///
/// with the weight q = w b of a length [N/m], the weight w per area and the width b; the lateral stiffness B = D_11 b,
/// the torsional stiffness C = 4 D_33 b and the warping stiffness W = D_11 b^3 / 12, which a clamp causes that holds
/// the strip over its whole width (Vlasov). Its minimum over v leaves an eigenvalue problem for theta: with s = 1 - x /
/// L,
///
///     theta'' - warping theta'''' + k^2 s^4 theta = 0,   k = q L^3 / (2 sqrt(B C)),   warping = W / (C L^2)
///
/// Without warping 2 k = 12.85 (Timoshenko and Gere, Theory of elastic stability, chapter 6; the zero of a Bessel
/// function). The width must be small against the length, and the strip stiff in its own plane.
/// @return 2 k = q L^3 / sqrt(B C) at which the straight strip becomes unstable [-], from cubic finite elements
[[nodiscard]] double lateralBucklingNumber(double warping);

/// The weight per area at which such a strip buckles [N/m^2].
/// @param bending D_11 [N m]  @param twisting D_33 [N m]  @param width b [m]  @param length L [m]
[[nodiscard]] double lateralBucklingWeight(double bending, double twisting, double width, double length);

/// A strip that is clamped upright at its upper end, and stands with its lower end on a floor, without weight. The
/// clamp has moved down by a share of the strip's length, and the strip has bent. Its lower end turns freely and
/// sticks. The friction that this needs follows from the elastica with the slope theta from the vertical,
///
///     theta'' = -p sin(theta) + q cos(theta),   theta'(0) = 0,   theta(1) = 0
///
/// whose ends are above each other at the distance 1 - shortening. p and q are the vertical and the horizontal force of
/// the floor, times L^2 / B. (Sano, Yamaguchi and Wada 2017, Slip morphology of elastic strips on frictional rigid
/// substrates.) @param shortening above 0 and at most 0.5 [-]
/// @return the coefficient of friction q / p at which the lower end begins to slip [-]
[[nodiscard]] double frictionOfPressedStrip(double shortening);

/// The energy per area of a picture frame test [J/m^2]. The sides of a square along warp and weft keep their length,
/// and its angles change by `angle` [rad].
[[nodiscard]] double pictureFrameEnergy(const sim::fabric::Material& material, double angle);

/// The energy per area of simple shear along warp by the shear `shear` [-]: x + shear y, y [J/m^2].
[[nodiscard]] double simpleShearEnergy(const sim::fabric::Material& material, double shear);

/// Young's modulus times thickness along the bias [N/m]. With the compliances S of warp and weft it is
/// 4 / (S_11 + S_22 + 2 S_12 + 1 / G).
[[nodiscard]] double biasModulus(const sim::fabric::Material& material);

/// The frequency of a square membrane that is stretched by the same factor in both directions and held at its sides
/// [1/s]. With Saint Venant-Kirchhoff's law and no contraction across, its tension per width is S = C (stretch^2 - 1)
/// / 2, and f = sqrt(S / density) sqrt(m^2 + n^2) / (2 side).
/// @param modulus C [N/m]  @param density at rest [kg/m^2]  @param side at rest [m]  @param m half waves, also n
[[nodiscard]] double membraneFrequency(double modulus, double stretch, double density, double side, int m, int n);

/// The lowest frequency of a strip that is clamped at one end, 3.5160 sqrt(B / density) / (2 pi L^2) [1/s].
/// @param bending B [N m]  @param density [kg/m^2]  @param length L [m]
[[nodiscard]] double cantileverFrequency(double bending, double density, double length);

/// The shape of that mode, 1 at the tip. @param share distance from the clamp over the length, 0 to 1 [-]
[[nodiscard]] double cantileverMode(double share);

/// The acceleration of a sheet on an incline, g (sin a - mu cos a) [m/s^2]. @param slope tan a, above `friction`
[[nodiscard]] double slidingAcceleration(double slope, double friction, double gravity);

/// The speed at which drag carries the weight of a sheet that falls normal to its plane, sqrt(2 density g / (rho C_D))
/// [m/s]. @param density of the sheet [kg/m^2]  @param airDensity rho [kg/m^3]  @param drag C_D [-]
[[nodiscard]] double terminalSpeed(double density, double airDensity, double drag, double gravity);

/// The mass of the air that a square plate accelerates along its normal, per area: 0.579 pi/4 rho L [kg/m^2] (Brennen
/// 1982, A review of added mass and fluid inertial forces).
[[nodiscard]] double addedMassOfSquare(double airDensity, double side);

/// A fall from rest against drag that rises with the square of the speed.
struct TerminalFall {
  double speed = 0.0;    ///< terminal [m/s]
  double gravity = 0.0;  ///< [m/s^2]
  double inertia = 1.0;  ///< mass with the added mass of the air, over the mass [-]

  /// After that time [s]: a speed^2 / g log(cosh(g t / (a speed))) [m], with the inertia a.
  [[nodiscard]] double distance(double time) const;
};

}  // namespace drape::report::validation
