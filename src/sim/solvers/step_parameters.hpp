#pragma once

#include "sim/adaptive/auto_options.hpp"
#include "sim/contact/contact_parameters.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/simd/jacobi_options.hpp"
#include "sim/systems/iteration_options.hpp"

namespace drape::sim {

/// The time integration, for all solvers of a backward-Euler step.
enum class Integration {
  BackwardEuler,  ///< first order, damps fast motion strongly
  Theta,          ///< a backward-Euler step over theta h, extrapolated to h; theta = 1/2 is the implicit midpoint rule
  Bdf2            ///< second order from the last two states (backward differentiation formula)
};

/// All parameters of a step: those that all methods share, the time integration, and the options of each method. Any of
/// them may change between two steps.
struct StepParameters : CommonParameters {
  int substeps = 1;                                      ///< equal parts of a step [-]
  Integration integration = Integration::BackwardEuler;  ///< of all solvers of a backward-Euler step
  double theta = 0.5;                                    ///< of Integration::Theta, 1/2 to 1 [-]
  bool keepMomentum = false;                             ///< restore the momentum of free cloth after each substep

  simd::JacobiOptions jacobi;
  IterationOptions iteration;
  adaptive::AutoOptions automatic;
  contact::ContactParameters contact;
};

}  // namespace drape::sim
