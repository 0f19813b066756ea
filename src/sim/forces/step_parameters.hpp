#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/forces/contact_parameters.hpp"
#include "sim/model/vector.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace drape {

/// The derivative of a spring's force in the matrix of implicit methods (docs/theory/method.md compares them).
enum class ForceDerivative {
  Stabilised,  ///< the paper's eq. 16: exact when stretched, k (l0/L) d d^T when compressed
  Exact,       ///< the paper's eq. 15: k [(1 - l0/L) I + (l0/L) d d^T]; indefinite when compressed
  Scalar,      ///< k I, as Desbrun, Schroeder and Barr (1999)
  Axial,       ///< k d d^T, as Volino and Magnenat-Thalmann
  TensionOnly  ///< exact when stretched, nothing when compressed, as Choi and Ko (2002)
};

/// The time integration, for all solvers of a backward-Euler step.
enum class Integration {
  BackwardEuler,  ///< first order, damps fast motion strongly
  Theta,          ///< a backward-Euler step over theta h, extrapolated to h; theta = 1/2 is the implicit midpoint rule
  Bdf2            ///< second order from the last two states (backward differentiation formula)
};

/// The precision of a step's arithmetic. States are always stored in double.
enum class Precision { Float, Double };

/// The largest relaxation for which an even number of block-Jacobi sweeps is stable. For a mode with Jacobi eigenvalue
/// mu >= -1, k sweeps with relaxation w give g <= 1 + (2 w - 1)^(k+1) times the exact velocity change. A backward-Euler
/// oscillator is stable for g <= 4/3; two sweeps reach that at w = 0.847.
inline constexpr double evenSweepsRelaxation = 0.8;

struct BodyStep;

/// The parameters of a step. Any of them may change between two steps.
struct StepParameters {
  double timeStep = 1.0 / 150.0;  ///< h [s]
  double stiffness = 100.0;       ///< k_s [N/m] of every spring
  double damping = 0.0;           ///< C_d [N s/m] of every spring
  double gravity = 9.81;          ///< acceleration downwards (-y) [m/s^2]
  double drag = 0.0;              ///< drag coefficient C_D [-]
  double lift = 0.0;              ///< lift coefficient C_L [-]
  double airDensity = 1.225;      ///< rho [kg/m^3]
  Vec3 wind = Vec3::Zero();       ///< velocity of the air [m/s]

  int substeps = 1;                                          ///< equal parts of a step [-]
  ForceDerivative derivative = ForceDerivative::Stabilised;  ///< of all implicit methods
  Integration integration = Integration::BackwardEuler;      ///< of all solvers of a backward-Euler step
  double theta = 0.5;                                        ///< of Integration::Theta, 1/2 to 1 [-]
  int sweeps = 1;                                            ///< block-Jacobi sweeps of one_iteration [-]
  double relaxation = 1.0;                                   ///< of these sweeps; below 1: damped Jacobi [-]
  int iterations = 10;                                       ///< of methods with a fixed number of iterations [-]
  double spectralRadius = 0.8;   ///< assumed for the Jacobi iteration, for its acceleration [-]
  double tolerance = 1e-6;       ///< relative residual at which a solve ends [-]
  int maxIterations = 1000;      ///< at which a solve gives up [-]
  double costBudget = 500.0;     ///< of `auto`: spring evaluations per simulated second [1e6/s]
  bool soften = false;           ///< `auto` keeps to the cost budget by softer springs; else a step may exceed it
  double errorTolerance = 1e-4;  ///< of `auto`: allowed mean position error after 0.2 s of motion [m]
  bool keepMomentum = false;     ///< restore the momentum of free cloth after each substep
  Precision precision = Precision::Double;  ///< of methods that support both
  int threads = 1;                          ///< threads a step may use [-]; the result does not depend on it

  ContactParameters contact;
};

/// Thrown out of a step when StepInputs::stop requests a stop. `auto` and `newton` throw it with the state as it was at
/// the start of the substep; the step is lost.
struct StepStopped {};

/// External actions on the cloth during one step.
struct StepInputs {
  std::optional<Attachment> attachment;
  const std::vector<BodyStep>* bodies = nullptr;  ///< over this step (contact/body.hpp); null: none
  /// Methods whose steps may take seconds check it now and then and throw StepStopped.
  std::stop_token stop = {};
  /// Called at the same points, to show progress or to check a deadline. An exception that it throws ends the step like
  /// StepStopped. Null if not needed.
  const std::function<void()>* onProgress = nullptr;
};

/// Ends the step if a stop is requested, and reports progress.
inline void checkStop(const StepInputs& inputs) {
  if (inputs.stop.stop_requested()) {
    throw StepStopped();
  }
  if (inputs.onProgress != nullptr) {
    (*inputs.onProgress)();
  }
}

}  // namespace drape
