#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/vector.hpp"

#include <cmath>
#include <numbers>

/// The formulas of the method, as pure functions of one vertex or one spring. Equation numbers are those of the paper
/// on the one-iteration implicit mass-spring step (docs/theory/method.md cites it and lists the differences from it).
///
/// | symbol | meaning                                         | unit   |
/// |--------|-------------------------------------------------|--------|
/// | L, l0  | present and rest length of a spring             | m      |
/// | d      | unit vector from vertex i to vertex j           | -      |
/// | k      | spring stiffness k_s                            | N/m    |
/// | J_ij   | dF_i / dx_j, the positive block between i and j | N/m    |
/// | C_d    | spring damping                                  | N s/m  |
/// | K      | 1/2 rho C S, air density, coefficient, area     | kg/m   |
namespace drape::sim::kernels {

/// Springs shorter than this fraction of their rest length have no direction.
inline constexpr double shortestLength = 1e-9;

/// The force that a spring exerts on vertex i [N]: towards j when it is stretched.
/// @param offset x_j - x_i [m]
[[nodiscard]] inline Vec3 springForce(const Vec3& offset, double restLength, double stiffness) {
  const double length = offset.norm();
  if (length <= shortestLength * restLength) {
    return Vec3::Zero();
  }
  return (stiffness * (length - restLength) / length) * offset;
}

/// J_ij, the positive block between the ends of a spring, in one of its variants. With r = l0/L:
///
/// | variant      | stretched                     | compressed                     | semi-definite, derivative     |
/// |--------------|-------------------------------|--------------------------------|-------------------------------|
/// | Stabilised   | k [(1 - r) I + r d d^T]       | k r d d^T (eq. 16)             | always; only when stretched   |
/// | Exact        | k [(1 - r) I + r d d^T]       | the same (eq. 15)              | only when stretched; always   |
/// | Scalar       | k I                           | k I                            | always; only for l0 = 0       |
/// | Axial        | k d d^T                       | k d d^T                        | always; only along the spring |
/// | TensionOnly  | k [(1 - r) I + r d d^T]       | 0                              | always; only when stretched   |
///
/// A spring without direction (L -> 0) couples with k I; with zero for TensionOnly.
[[nodiscard]] inline Mat3 springDerivative(const Vec3& offset, double restLength, double stiffness,
                                           ForceDerivative variant = ForceDerivative::Stabilised) {
  const double length = offset.norm();
  const bool compressed = length < restLength;
  if (variant == ForceDerivative::TensionOnly && compressed) {
    return Mat3::Zero();
  }
  if (variant == ForceDerivative::Scalar || length <= shortestLength * restLength || length == 0.0) {
    return stiffness * Mat3::Identity();
  }
  const Vec3 direction = offset / length;
  const Mat3 outer = direction * direction.transpose();
  if (variant == ForceDerivative::Axial) {
    return stiffness * outer;
  }
  const double ratio = restLength / length;
  const Mat3 along = (stiffness * ratio) * outer;
  const bool dropped = compressed && variant == ForceDerivative::Stabilised;
  return dropped ? along : Mat3(along + (stiffness * (1.0 - ratio)) * Mat3::Identity());
}

/// Damping of the relative velocity of a spring's ends (eq. 12): the force on vertex i [N].
[[nodiscard]] inline Vec3 dampingForce(const Vec3& velocity, const Vec3& neighbourVelocity, double damping) {
  return -damping * (velocity - neighbourVelocity);
}

/// Drag (eq. 18): -K |n.v^| |v|^2 v^ [N], with v relative to the air.
/// @param normal unit normal of the surface  @param speed |v|, positive  @param heading v^ = v / |v|
[[nodiscard]] inline Vec3 dragForce(const Vec3& normal, double speed, const Vec3& heading, double dragFactor) {
  return (-dragFactor * std::abs(normal.dot(heading)) * speed * speed) * heading;
}

/// Lift (eqs. 19, 20): K (1 - |n.v^|) |v|^2 U [N] with U = (n x v^) x v^, where n is turned to face v^. The paper lacks
/// the absolute value; without it the factor would be up to 2 where the back of the surface faces v^.
[[nodiscard]] inline Vec3 liftForce(const Vec3& normal, double speed, const Vec3& heading, double liftFactor) {
  const double facing = normal.dot(heading);
  const Vec3 front = facing < 0.0 ? Vec3(-normal) : normal;
  const Vec3 direction = front.cross(heading).cross(heading);
  return (liftFactor * (1.0 - std::abs(facing)) * speed * speed) * direction;
}

/// The slope of a thin plate's lift at zero incidence: the force is at most R S |n.v| |v| with R = 1/2 rho 2 pi (thin
/// aerofoils: Anderson, Fundamentals of Aerodynamics, eq. 4.33).
/// @param airDensity rho [kg/m^3]  @return R [kg/m^3]
[[nodiscard]] inline double liftRise(double airDensity) {
  return std::numbers::pi * airDensity;
}

/// The lift above, limited to that of a thin plate; continuous at zero incidence [N].
/// @param riseFactor R S [kg/m]
[[nodiscard]] inline Vec3 risingLiftForce(const Vec3& normal, double speed, const Vec3& heading, double liftFactor,
                                          double riseFactor) {
  const Vec3 force = liftForce(normal, speed, heading, liftFactor);
  const double limit = riseFactor * std::abs(normal.dot(heading)) * speed * speed;
  const double size = force.norm();
  return size > limit ? Vec3(force * (limit / size)) : force;
}

/// Factors of the air's force on a vertex: 1/2 rho C S each [kg/m].
struct AirFactors {
  double drag = 0.0;
  double lift = 0.0;
  double edgeDrag = 0.0;  ///< of plateForce
};

/// The force on a thin plate at the angle of attack a, sin a = n.v^ [N]: drag with C = C_edge + (C_D - C_edge) sin^2 a
/// against the motion, and lift with C_L sin 2a. These are the quasi-steady translational coefficients that were
/// measured on falling plates and on wings (Andersen, Pesavento and Wang 2005, Unsteady aerodynamics of fluttering and
/// tumbling plates; Wang, Birch and Dickinson 2004). With f = n.v and s = |v|:
///
///     force = -(K_edge s + (K_D - K_edge - 2 K_L) f^2 / s) v - 2 K_L s f n
///
/// Lift does no work, and it vanishes along the wind and across it.
[[nodiscard]] inline Vec3 plateForce(const Vec3& normal, double speed, const Vec3& heading, const AirFactors& factors) {
  const double sine = normal.dot(heading);
  const double along = factors.edgeDrag + (factors.drag - factors.edgeDrag - 2.0 * factors.lift) * sine * sine;
  return speed * speed * (-along * heading - 2.0 * factors.lift * sine * normal);
}

/// The air's force on a vertex [N], limited to the force that stops it relative to the air within one step. Otherwise
/// drag, evaluated at the start of the step as in the paper, could reverse and increase the velocity of a light vertex.
/// @param velocity of the vertex relative to the air [m/s]  @param asPlate whether plateForce acts, else eqs. 18 to 20
/// @param mass [kg]  @param timeStep [s]
[[nodiscard]] inline Vec3 airForce(const Vec3& normal, const Vec3& velocity, const AirFactors& factors, bool asPlate,
                                   double mass, double timeStep) {
  const double speed = velocity.norm();
  if (!(speed > 0.0)) {
    return Vec3::Zero();
  }
  const Vec3 heading = velocity / speed;
  const Vec3 force =
      asPlate ? plateForce(normal, speed, heading, factors)
              : Vec3(dragForce(normal, speed, heading, factors.drag) + liftForce(normal, speed, heading, factors.lift));
  const double limit = mass * speed / timeStep;
  const double size = force.norm();
  return size > limit ? Vec3(force * (limit / size)) : force;
}

}  // namespace drape::sim::kernels
