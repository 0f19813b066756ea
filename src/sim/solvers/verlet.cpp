#include "sim/external_forces.hpp"
#include "sim/forces.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

/// Stoermer-Verlet in its position form (drift, kick, drift), one evaluation of the forces a step:
///
///     x_m = x + h/2 v,   v' = v + h a(x_m, v),   x' = x_m + h/2 v'
///
/// Symplectic, time-reversible and of second order for forces that depend on positions. What depends on velocities
/// (damping, air) is taken with the velocity of the step's start, which keeps the step explicit and makes it of first
/// order in those forces.
///
/// The hand's spring can be far stiffer than the cloth, so it alone is implicit: see pullByHand.
class VerletSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    const double h = parameters.timeStep;
    drift(model, 0.5 * h, state);
    evaluateForces(model, parameters, {}, state, workers_, force_);
    for (std::size_t i = 0; i < force_.size(); ++i) {
      if (model.pinned[i]) {
        state.velocities[i].setZero();
      } else {
        state.velocities[i] += (h / model.vertexMass[i]) * force_[i];
      }
    }
    if (inputs.grab) {
      pullByHand(model, h, *inputs.grab, state);
    }
    drift(model, 0.5 * h, state);
    state.time += h;
    return {};
  }

 private:
  static void drift(const ClothModel& model, double time, ClothState& state) {
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      if (!model.pinned[i]) {
        state.positions[i] += time * state.velocities[i];
      }
    }
  }

  /// The hand's impulse J on the held point p, from where the point ends: J = h k (target - p - h/2 u'), u' = u + W J,
  /// with u the point's velocity and W its inverse mass, the sum of w_i^2 / m_i. J is bounded like the force. Stable
  /// for any stiffness of the hand, and the cloth's own limit stays what it is.
  static void pullByHand(const ClothModel& model, double h, const Grab& grab, ClothState& state) {
    const HandPull pull = handPull(model, grab, state);
    Vec3 reach = grab.target;
    double inverseMass = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = pull.vertices[c];
      const double weight = pull.weights[static_cast<Eigen::Index>(c)];
      reach -= weight * (state.positions[v] + 0.5 * h * state.velocities[v]);
      inverseMass += model.pinned[v] ? 0.0 : weight * weight / model.vertexMass[v];
    }
    Vec3 impulse = (h * grab.stiffness / (1.0 + 0.5 * h * h * grab.stiffness * inverseMass)) * reach;
    impulse *= std::min(1.0, h * grab.maxForce / std::max(impulse.norm(), std::numeric_limits<double>::min()));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = pull.vertices[c];
      if (!model.pinned[v]) {
        state.velocities[v] += (pull.weights[static_cast<Eigen::Index>(c)] / model.vertexMass[v]) * impulse;
      }
    }
  }

  Workers workers_;
  std::vector<Vec3> force_;  // [N], one a vertex
};

std::string warning(const ClothModel& model, const StepParameters& parameters) {
  return stepLimitWarning(parameters, verletStepLimit(model, parameters));
}

}  // namespace

SolverInfo solvers::verlet() {
  return {
      .name = "verlet",
      .title = "Verlet (explicit)",
      .help =
          "Stoermer-Verlet: symplectic, second order, one evaluation of the forces a step. The most accurate method "
          "for its price while the step is below the mesh's stability limit; above it the cloth blows up, and stiff "
          "or fine cloth has a low limit.",
      .source = "Stoermer, 1907; Verlet, 1967, Computer experiments on classical fluids",
      .backwardEuler = false,
      .settings = {},
      .warning = warning,
      .stepLimit = verletStepLimit,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<VerletSolver>(); }};
}

}  // namespace drape
