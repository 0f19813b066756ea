#include "sim/fabric/fabric.hpp"
#include "sim/forces/attachment.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/colouring.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/systems/position_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace drape::sim {
namespace {

/// Vertex block descent (Chen, Liu, Yang and Yuksel 2024): the backward-Euler step as the minimum of
/// G(x) = |x - y|_M^2 / (2 h^2) + E(x), found by `iterations` sweeps. In a sweep every vertex takes one Newton step
/// H_i dx_i = f_i on G while its neighbours are fixed. Vertices of one colour are processed in parallel.
///
/// | here, times h^2                              | paper                                          |
/// |----------------------------------------------|------------------------------------------------|
/// | y = x_n + h v_n + h^2 a                      | inertial positions, gravity and air at x_n, v_n |
/// | H_i = (m_i + n_i h C_d) I + h^2 sum_j J_ij   | the vertex's Hessian; J_ij as `derivative` says |
/// | r_i = m_i (y_i - x_i) + h^2 f_i(x) + damping | the force on the vertex                         |
///
/// Damping is a dashpot between the ends of a spring, -(C_d / h) (dx_i - dx_j) with dx the displacement since the start
/// of the step, as in the other methods (the paper scales the stiffness instead).
///
/// The sweeps start from y (inertia). The paper's adaptive start needs the velocity of the previous step, which the
/// state does not contain. The disadvantage is that cloth at rest first falls in every step and is then lifted again.
///
/// A spectral radius rho > 0 accelerates the sweeps as in the paper (after Wang 2015): after sweep n x = w (x_swept -
/// x_{n-2}) + x_{n-2}, with w_1 = 1, w_2 = 2 / (2 - rho^2), w_n = 4 / (4 - rho^2 w_{n-1}). See overshoots() for its
/// limit.
class VbdSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    const RaggedRows<int>& colours = colours_.get(
        model, [](const ClothModel& m) { return colourVertices(m.fabric ? m.fabric->pairEnds : m.springEnds); });
    predictPositions(model, parameters, state, workers_, inertial_);
    start_ = state.positions;
    state.positions = inertial_;
    Acceleration acceleration(parameters.iteration.spectralRadius);
    for (int iteration = 0; iteration < parameters.iteration.iterations; ++iteration) {
      if (parameters.iteration.spectralRadius > 0.0) {
        before_ = state.positions;
      }
      forEachByColour(workers_, parameters.threads, colours,
                      [&](std::size_t i) { relax(model, parameters, inputs, i, state); });
      if (const double weight = acceleration.next(); weight > 1.0) {
        workers_.forEach(parameters.threads, older_.size(), [&](std::size_t i) {
          state.positions[i] = older_[i] + weight * (state.positions[i] - older_[i]);
        });
      }
      older_.swap(before_);
    }
    velocitiesFromPositions(model, parameters.timeStep, start_, state);
    state.time += parameters.timeStep;
    return {.iterations = parameters.iteration.iterations};
  }

 private:
  /// The weights w_n of the acceleration.
  class Acceleration {
   public:
    explicit Acceleration(double spectralRadius) : square_(spectralRadius * spectralRadius) {}

    double next() {
      ++sweep_;
      if (sweep_ == 2) {
        weight_ = 2.0 / (2.0 - square_);
      } else if (sweep_ > 2) {
        weight_ = 4.0 / (4.0 - square_ * weight_);
      }
      return weight_;
    }

   private:
    double square_;
    double weight_ = 1.0;
    int sweep_ = 0;
  };

  /// Force and stiffness of the springs or the fabric at one vertex.
  struct Local {
    Vec3 force = Vec3::Zero();      // [N]
    Mat3 stiffness = Mat3::Zero();  // [N/m]
    double largest = 0.0;           // upper bound of its eigenvalues [N/m]
    Vec3 drag = Vec3::Zero();       // sum of (dx_j - dx_i) [m]
    double damping = 0.0;           // C_d [N s/m]
    double ends = 0.0;              // n_i [-]
  };

  [[nodiscard]] Local localOfSprings(const ClothModel& model, const StepParameters& parameters, std::size_t i,
                                     const ClothState& state) const {
    Local local;
    local.damping = parameters.material.damping;
    local.ends = static_cast<double>(model.springEnds[i].size());
    const Vec3 displacement = state.positions[i] - start_[i];
    for (const SpringEnd& springEnd : model.springEnds[i]) {
      const auto j = static_cast<std::size_t>(springEnd.neighbour);
      const Spring& spring = model.springs[static_cast<std::size_t>(springEnd.spring)];
      const double own = parameters.material.stiffness * spring.relativeStiffness;
      const Vec3 offset = state.positions[j] - state.positions[i];
      local.force += kernels::springForce(offset, spring.restLength, own);
      local.stiffness += kernels::springDerivative(offset, spring.restLength, own, parameters.derivative);
      local.largest += own;
      local.drag += (state.positions[j] - start_[j]) - displacement;
    }
    return local;
  }

  [[nodiscard]] static Local localOfFabric(const ClothModel& model, const StepParameters& parameters, std::size_t i,
                                           const ClothState& state) {
    Local local;
    local.force = fabric::elasticForceOn(model, state.positions, i);
    local.stiffness = fabric::stiffnessAt(model, state.positions, i, parameters.derivative);
    local.largest = std::max(model.fabricStiffness[i], local.stiffness.norm());
    return local;
  }

  /// One vertex's Newton step on G.
  void relax(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs, std::size_t i,
             ClothState& state) const {
    if (model.pinned[i]) {
      return;
    }
    const double h = parameters.timeStep;
    Local local =
        model.fabric ? localOfFabric(model, parameters, i, state) : localOfSprings(model, parameters, i, state);
    if (inputs.attachment) {
      addAttachment(model, *inputs.attachment, i, state, local.force, local.stiffness);
    }
    const double isotropic = model.vertexMass[i] + local.ends * h * local.damping;
    const Vec3 residual = model.vertexMass[i] * (inertial_[i] - state.positions[i]) + h * h * local.force +
                          h * local.damping * local.drag;
    state.positions[i] +=
        solve(h * h * local.stiffness + isotropic * Mat3::Identity(), residual, isotropic + h * h * local.largest);
  }

  /// H^-1 r. If the chosen derivative makes H indefinite, Newton's step could increase G. Then H is replaced by an
  /// upper bound, with k I for every spring, whose step does not increase G.
  static Vec3 solve(const Mat3& hessian, const Vec3& residual, double isotropic) {
    const Eigen::LLT<Mat3> factors(hessian);
    return factors.info() == Eigen::Success ? Vec3(factors.solve(residual)) : Vec3(residual / isotropic);
  }

  /// Adds the attachment's force and secant stiffness if vertex i is a corner of its triangle.
  static void addAttachment(const ClothModel& model, const Attachment& attachment, std::size_t i,
                            const ClothState& state, Vec3& force, Mat3& stiffness) {
    const std::optional<double> weight = attachedCorners(model, attachment).weightOf(i);
    if (weight) {
      const AttachmentForce pull = attachmentForce(model, attachment, state);
      force += *weight * pull.force;
      stiffness += (*weight * *weight * pull.stiffness) * Mat3::Identity();
    }
  }

  Workers workers_;
  ModelCache<RaggedRows<int>> colours_;
  std::vector<Vec3> start_;     // x_n [m]
  std::vector<Vec3> inertial_;  // y [m]
  std::vector<Vec3> before_;    // positions before the current sweep [m]
  std::vector<Vec3> older_;     // positions before the sweep before that [m]
};

/// n accelerated sweeps multiply the error of a mode by T_n(z / rho) / T_n(1 / rho), with z its eigenvalue, |z| <= rho,
/// and T_n Chebyshev's polynomial. For n > 1 this factor q can be -1 / T_n(1 / rho). The sweeps start from the inertial
/// positions, so a very stiff mode continues with x' = q (x + h v), which grows if q < -1/3. Hence
/// T_n(1 / rho) = cosh(n arcosh(1 / rho)) >= 3 is required.
bool overshoots(int iterations, double spectralRadius) {
  constexpr double smallest = 3.0;
  constexpr double rounding = 1e-12;
  return iterations > 1 && spectralRadius > 0.0 &&
         std::cosh(iterations * std::acosh(1.0 / spectralRadius)) < smallest * (1.0 - rounding);
}

/// Below the limit on (h omega)^2 the position error is a few times that of the converged step
/// (docs/experiments/2026-11-22-solver-comparison.md).
std::optional<SolverWarning> vbdWarning(const ClothModel& model, const StepParameters& parameters) {
  if (!overshoots(parameters.iteration.iterations, parameters.iteration.spectralRadius)) {
    constexpr double perIteration = 1.0;  // limit of (h omega)^2 [-]
    return slackWarning(model, parameters, perIteration);
  }
  int enough = parameters.iteration.iterations;
  while (overshoots(enough, parameters.iteration.spectralRadius)) {
    ++enough;
  }
  return SolverWarning{.kind = SolverWarning::Kind::SpectralRadius,
                       .iterations = parameters.iteration.iterations,
                       .neededIterations = enough,
                       .spectralRadius = parameters.iteration.spectralRadius};
}

}  // namespace

SolverInfo solvers::vbd() {
  return {
      .name = "vbd",
      .title = "Vertex block descent",
      .help =
          "Backward Euler as a minimisation: one vertex after the other takes a Newton step while its neighbours "
          "are fixed. Robust at large steps with three or more sweeps. A sweep costs about one evaluation of forces "
          "and derivatives. With few sweeps stiff cloth is slack and slow.",
      .source = "Chen, Liu, Yang and Yuksel (2024), Vertex block descent",
      .backwardEuler = true,
      .takesFabric = true,
      .settings = {"iterations", "derivative", "spectral_radius"},
      .warning = vbdWarning,
      .stepLimit = nullptr,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<VbdSolver>(); }};
}

}  // namespace drape::sim
