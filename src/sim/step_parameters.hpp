#pragma once

#include "sim/contact/contact_parameters.hpp"
#include "sim/vector.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace drape {

/// Which derivative of a spring's force the implicit methods put into their matrix (docs/theory/method.md compares
/// them).
enum class ForceDerivative {
  Stabilised,  ///< the paper's eq. 16: exact when stretched, k (l0/L) d d^T when compressed
  Exact,       ///< the paper's eq. 15: k [(1 - l0/L) I + (l0/L) d d^T]; indefinite when compressed
  Scalar,      ///< k I, as Desbrun, Schroeder and Barr (1999)
  Axial,       ///< k d d^T, as Volino and Magnenat-Thalmann
  TensionOnly  ///< exact when stretched, nothing when compressed, as Choi and Ko (2002)
};

/// How a step's end is found from its start, with any solver of a backward-Euler step.
enum class Integration {
  BackwardEuler,  ///< first order, damps fast motion strongly
  Theta,          ///< a backward-Euler step over theta h, extrapolated to h; theta = 1/2 is the implicit midpoint rule
  Bdf2            ///< second order from the last two states (backward differentiation formula)
};

/// The numbers that a step calculates with. States are kept in double whatever the step uses.
enum class Precision { Float, Double };

/// The largest relaxation with which an even number of block-Jacobi sweeps is harmless. k sweeps with relaxation w
/// answer a mode of the Jacobi eigenvalue mu >= -1 with g <= 1 + (2 w - 1)^(k+1) times the exact velocity change, and a
/// backward- Euler oscillator stays stable while g <= 4/3; two sweeps reach that at w = 0.847.
inline constexpr double evenSweepsRelaxation = 0.8;

struct BodyStep;

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

  int substeps = 1;                                          ///< equal parts that a step is taken in [-]
  ForceDerivative derivative = ForceDerivative::Stabilised;  ///< of all implicit methods
  Integration integration = Integration::BackwardEuler;      ///< of all solvers of a backward-Euler step
  double theta = 0.5;                                        ///< of Integration::Theta, 1/2 to 1 [-]
  int sweeps = 1;                                            ///< block-Jacobi sweeps of one_iteration [-]
  double relaxation = 1.0;                                   ///< damping of these sweeps; below 1: damped Jacobi [-]
  int iterations = 10;                                       ///< of the methods that take a fixed number [-]
  double spectralRadius = 0.8;                               ///< of the Jacobi iteration, for its acceleration [-]
  double tolerance = 1e-6;                                   ///< relative residual at which a solve ends [-]
  int maxIterations = 1000;                                  ///< at which a solve gives up [-]
  double work = 500.0;           ///< that `auto` may do, 1e6 evaluations of a spring a simulated second [1e6/s]
  bool soften = false;           ///< `auto` keeps to that by softer springs; else a step takes what it needs
  double errorTolerance = 1e-4;  ///< of `auto`: mean position error that 0.2 s of motion may build up [m]
  bool keepMomentum = false;     ///< free cloth is given back the momentum it lost
  Precision precision = Precision::Double;  ///< of the methods that have both
  int threads = 1;                          ///< threads a step may use [-]; the result does not depend on it

  ContactParameters contact;
};

/// A hand that holds the cloth: a spring from a point on a triangle to a target, whose force is bounded.
struct Attachment {
  int triangle = 0;                 ///< index into ClothModel::triangles
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners, summing to 1
  Vec3 target = Vec3::Zero();       ///< where the hand is [m]
  double stiffness = 0.0;           ///< [N/m]
  double maxForce = 0.0;            ///< the force never exceeds this [N]
};

/// What acts on the cloth from outside during one step.
struct StepInputs {
  std::optional<Attachment> attachment;
  const std::vector<BodyStep>* bodies = nullptr;  ///< that are there, over this step (contact/body.hpp); null: none
  /// Called now and then by methods that may take seconds over a step. What it throws ends the step, and leaves the
  /// state somewhere in it. Null: nobody wants to know.
  const std::function<void()>* mayStop = nullptr;
};

}  // namespace drape
