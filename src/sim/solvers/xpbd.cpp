#include "sim/fabric/fabric.hpp"
#include "sim/forces/attachment.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/colouring.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/simd/constraint_run.hpp"
#include "sim/solvers/batch_solver.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/fabric_constraints.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/systems/position_step.hpp"

namespace drape::sim {
namespace {

/// Extended position-based dynamics (Macklin, Mueller, Chentanez 2016). Springs are distance constraints C = L - l0 of
/// compliance 1/k, solved by `iterations` coloured Gauss-Seidel sweeps. The sweeps start from the positions y predicted
/// by inertia, gravity and air. The multipliers start at zero in each step.
///
/// | here        | paper                                                                    |
/// |-------------|--------------------------------------------------------------------------|
/// | compliance  | alpha~ = 1 / (k h^2) (sec. 4)  , stored as its inverse, as k may be 0 |
/// | multiplier  | dlambda = (-C - alpha~ lambda) / (w_a + w_b + alpha~) (eq. 18)           |
/// | correction  | dx = M^-1 grad C dlambda (eq. 17)                                        |
///
/// A correction acts along the present direction of the spring. So the limit differs from the backward-Euler step where
/// springs rotate within the step: the multipliers agree with the lengths at the end, but M (x - y) = grad C lambda
/// uses intermediate directions (the paper neglects that residual, sec. 4).
///
/// Damping is then applied to the velocities, colour by colour: each spring's dashpot is solved implicitly for its two
/// ends, J = h C_d (v_b' - v_a'). This conserves momentum and cannot reverse the relative velocity. The attachment is a
/// constraint of three components (AttachmentConstraint).
///
/// In float, vector instructions take the same step (simd/constraint_run.hpp).
///
/// A fabric has two block constraints a triangle instead (FabricConstraints), always in double. Its damping is split
/// from the step by the Stepper.
class XpbdSolver final : public BatchSolver {
 public:
  StepReport steps(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, int count,
                   ClothState& state) override {
    if (parameters.precision == Precision::Float && !model.fabric) {
      run_.xpbd(model, parameters, parameters.iteration.iterations, inputs, count, state);
    } else {
      for (int i = 0; i < count; ++i) {
        stepInDouble(model, parameters, inputs, state);
      }
    }
    return {.iterations = count * parameters.iteration.iterations};
  }

 private:
  void stepInDouble(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                    ClothState& state) {
    const double h = parameters.timeStep;
    predictPositions(model, parameters, state, workers_, start_);
    state.positions.swap(start_);
    findInverseMasses(model);
    attachment_ = {};
    if (model.fabric) {
      correctFabric(model, parameters, inputs, state);
      velocitiesFromPositions(model, h, start_, state);
    } else {
      const RaggedRows<int>& colours = colours_.get(model, colourSprings);
      correctSprings(model, parameters, inputs, colours, state);
      velocitiesFromPositions(model, h, start_, state);
      if (parameters.material.damping > 0.0) {
        forEachByColour(workers_, parameters.threads, colours,
                        [&](std::size_t s) { damp(model.springs[s], h * parameters.material.damping, state); });
      }
    }
    state.time += h;
  }

  void correctSprings(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                      const RaggedRows<int>& colours, ClothState& state) {
    const double h = parameters.timeStep;
    multiplier_.assign(model.springs.size(), 0.0);
    for (int iteration = 0; iteration < parameters.iteration.iterations; ++iteration) {
      forEachByColour(workers_, parameters.threads, colours, [&](std::size_t s) {
        const double stiffness = parameters.material.stiffness * model.springs[s].relativeStiffness;
        project(model.springs[s], h * h * stiffness, s, state);
      });
      projectAttachment(model, h, inputs, state);
    }
  }

  void correctFabric(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                     ClothState& state) {
    // The moments of a fabric that is bent at rest are those at the start of the step, as is the force of the air.
    for (std::size_t v = 0; v < start_.size() && !model.fabric->restMoments.empty(); ++v) {
      state.positions[v] +=
          parameters.timeStep * parameters.timeStep * inverseMass_[v] * model.fabric->restMoments.forceOn(v, start_);
    }
    FabricConstraints& constraints = fabric_.get(model, [](const ClothModel& m) { return FabricConstraints(m); });
    constraints.begin(parameters.timeStep);
    for (int iteration = 0; iteration < parameters.iteration.iterations; ++iteration) {
      constraints.project(parameters.threads, workers_, state.positions);
      projectAttachment(model, parameters.timeStep, inputs, state);
    }
  }

  void findInverseMasses(const ClothModel& model) {
    inverseMass_.resize(model.vertexMass.size());
    for (std::size_t i = 0; i < inverseMass_.size(); ++i) {
      inverseMass_[i] = model.pinned[i] ? 0.0 : 1.0 / model.vertexMass[i];
    }
  }

  /// One constraint, eqs. 17 and 18 with numerator and denominator times h^2 k. @param inverseCompliance h^2 k [kg]
  void project(const Spring& spring, double inverseCompliance, std::size_t index, ClothState& state) {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const Vec3 offset = state.positions[b] - state.positions[a];
    const double length = offset.norm();
    if (length <= kernels::shortestLength * spring.restLength) {
      return;  // without a direction
    }
    const double weight = inverseMass_[a] + inverseMass_[b];
    const double change =
        -(inverseCompliance * (length - spring.restLength) + multiplier_[index]) / (inverseCompliance * weight + 1.0);
    multiplier_[index] += change;
    const Vec3 correction = (change / length) * offset;
    state.positions[a] -= inverseMass_[a] * correction;
    state.positions[b] += inverseMass_[b] * correction;
  }

  void projectAttachment(const ClothModel& model, double h, const StepInputs& inputs, ClothState& state) {
    if (!inputs.attachment) {
      return;
    }
    const Attachment& attachment = *inputs.attachment;
    const AttachedCorners corners = attachedCorners(model, attachment);
    const auto& [a, b, c] = corners.vertices;
    const Vec3 offset = corners.subtracted(attachment.target, [&](std::size_t v) { return state.positions[v]; });
    const auto moves =
        attachment_.correct(attachment, corners, h, offset, {inverseMass_[a], inverseMass_[b], inverseMass_[c]});
    for (std::size_t corner = 0; corner < 3; ++corner) {
      state.positions[corners.vertices[corner]] += moves[corner];
    }
  }

  /// One spring's dashpot, implicit for its two ends. @param strength h C_d [kg]
  void damp(const Spring& spring, double strength, ClothState& state) const {
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const double weight = inverseMass_[a] + inverseMass_[b];
    const Vec3 impulse = (strength / (1.0 + strength * weight)) * (state.velocities[b] - state.velocities[a]);
    state.velocities[a] += inverseMass_[a] * impulse;
    state.velocities[b] -= inverseMass_[b] * impulse;
  }

  simd::ConstraintRun run_;
  Workers workers_;
  ModelCache<RaggedRows<int>> colours_;
  ModelCache<FabricConstraints> fabric_;
  std::vector<double> inverseMass_;  // w_i [1/kg], one a vertex; 0 where pinned
  std::vector<double> multiplier_;   // lambda [N s^2], one a spring
  AttachmentConstraint attachment_;
  std::vector<Vec3> start_;  // positions at the start of the step [m]
};

/// Below the limit on (h omega)^2 the position error is a few times that of the converged step. In short steps
/// velocities are inexact, since they follow from positions in float
/// (docs/experiments/2026-11-22-solver-comparison.md).
std::optional<SolverWarning> xpbdWarning(const ClothModel& model, const StepParameters& parameters) {
  constexpr double minStepInFloat = 1.0 / 6000.0;   // [s]
  constexpr double minWithRounding = 1.0 / 6001.0;  // [s]
  if (parameters.precision == Precision::Float && !model.fabric &&
      parameters.timeStep / parameters.substeps < minWithRounding) {
    return SolverWarning{.kind = SolverWarning::Kind::InexactInFloat, .seconds = minStepInFloat};
  }
  constexpr double perIteration = 4.0;  // limit of (h omega)^2 [-]
  return slackWarning(model, parameters, perIteration);
}

}  // namespace

SolverInfo solvers::xpbd() {
  return {.name = "xpbd",
          .title = "XPBD",
          .help =
              "Extended position-based dynamics: springs, or the strains and curvatures of a fabric's triangles, are "
              "compliant constraints that are corrected one after the other. Cheap, and stable at any step. With few "
              "iterations stiff cloth is softer than "
              "specified; substeps help more than iterations.",
          .source = "Macklin, Mueller and Chentanez, 2016, XPBD",
          .backwardEuler = true,
          .takesFabric = true,
          .settings = {"iterations", "precision"},
          .warning = xpbdWarning,
          .stepLimit = nullptr,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<XpbdSolver>(); }};
}

}  // namespace drape::sim
