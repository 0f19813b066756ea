#include "sim/forces/external_forces.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/workers.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/registry.hpp"
#include "sim/systems/diagonal_change.hpp"
#include "sim/systems/scalar_system.hpp"

namespace drape::sim {
namespace {

/// Fast mass springs (Liu, Bargteil, O'Brien and Kavan, 2013): backward Euler as the minimum of
///
///     1/2 |x - y|^2_M + h^2 k / 2 sum_s |x_a - x_b - d_s|^2,   |d_s| = l0,   y = x_n + h v_n + h^2 M^-1 f_ext
///
/// over x and the directions d_s, alternately. For given x each d_s points along its spring (local step). For given d
/// the x solve a linear system with a constant matrix (global step),
///
///     (M + h^2 k L + h C_d L) x = M y + h^2 k sum_s A_s d_s + h C_d L x_n.
///
/// The paper has no damping of this form; here it is the force -C_d L (x - x_n) / h at the end of the step. The unknown
/// is u = x - x_n, which is small for slow cloth and zero at pins. The two terms of C_d then cancel:
///
///     (M + (h^2 k + h C_d) L) u = h M v_n + h^2 f_ext + h^2 k sum_s A_s (d_s - (x_a - x_b)_n)
///
/// Then v = u / h. The first directions are those at y.
///
/// The attachment's stiffness, the secant stiffness at the start of the step, is lumped on the corners of its triangle
/// as in the other implicit methods. It changes three diagonal entries at every step without a new factor
/// (diagonal_change.hpp).
class LocalGlobalSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    const double h = parameters.timeStep;
    const bool changed = system_.prepare(model, {h, parameters.material.stiffness, parameters.material.damping});
    const std::size_t count = state.positions.size();
    stretch_.resize(model.springs.size());
    inertia_.resize(count);
    move_.resize(count);
    workers_.forEach(parameters.threads, count, [&](std::size_t i) {
      inertia_[i] = h * (model.vertexMass[i] * state.velocities[i] + h * gravityAndAir(model, parameters, state, i));
      move_[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : Vec3(inertia_[i] / model.vertexMass[i]);
    });
    useAttachment(model, h, inputs, state, changed);
    for (int iteration = 0; iteration < parameters.iteration.iterations; ++iteration) {
      workers_.forEach(parameters.threads, model.springs.size(),
                       [&](std::size_t s) { updateDirection(model, parameters, state, s); });
      solveGlobally(model, parameters.threads);
    }
    finish(model, h, state);
    return {.iterations = parameters.iteration.iterations};
  }

 private:
  /// The local step: h^2 k (x_b - x_a - d_s) with x at the start of the step and the present d_s, the spring's part of
  /// the right side of its first end [kg m].
  void updateDirection(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                       std::size_t s) {
    const Spring& spring = model.springs[s];
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const Vec3 before = state.positions[b] - state.positions[a];
    const Vec3 now = before + move_[b] - move_[a];
    const double length = now.norm();
    const double weight =
        parameters.timeStep * parameters.timeStep * parameters.material.stiffness * spring.relativeStiffness;
    // A spring without direction exerts no force: d_s equals its offset.
    const bool directed = length > kernels::shortestLength * spring.restLength;
    stretch_[s] = weight * (before - (directed ? Vec3((spring.restLength / length) * now) : now));
  }

  void solveGlobally(const ClothModel& model, int threads) {
    const std::vector<std::size_t>& vertices = system_.vertices();
    rightSide_.resize(static_cast<Eigen::Index>(vertices.size()), 3);
    workers_.forEach(threads, vertices.size(), [&](std::size_t row) {
      const std::size_t i = vertices[row];
      Vec3 sum = inertia_[i];
      for (const SpringEnd& spring : model.springEnds[i]) {
        const Vec3& stretch = stretch_[static_cast<std::size_t>(spring.spring)];
        sum += spring.neighbour > static_cast<int>(i) ? stretch : Vec3(-stretch);
      }
      rightSide_.row(static_cast<Eigen::Index>(row)) = sum.transpose();
    });
    ScalarSystem::Columns answer = system_.solve(rightSide_);
    attachment_.applyTo(answer);
    workers_.forEach(threads, vertices.size(), [&](std::size_t row) {
      move_[vertices[row]] = answer.row(static_cast<Eigen::Index>(row)).transpose();
    });
  }

  /// Adds the attachment's force to the right side and its stiffness to the diagonal.
  void useAttachment(const ClothModel& model, double h, const StepInputs& inputs, const ClothState& state,
                     bool factorChanged) {
    if (!inputs.attachment) {
      attachment_.clear();
      return;
    }
    const AttachmentForce pull = attachmentForce(model, *inputs.attachment, state);
    const AttachmentDiagonal diagonal = pull.diagonal(h);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = pull.vertices[c];
      const auto corner = static_cast<Eigen::Index>(c);
      const Vec3 lag = pull.velocity - state.velocities[v];
      inertia_[v] += h * h * pull.weights[corner] * pull.force - h * diagonal.additions[corner] * lag;
    }
    attachment_.set(system_, factorChanged, diagonal.vertices, diagonal.additions);
  }

  void finish(const ClothModel& model, double h, ClothState& state) const {
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      state.velocities[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : Vec3(move_[i] / h);
      state.positions[i] += move_[i];
    }
    state.time += h;
  }

  Workers workers_;
  ScalarSystem system_;
  std::vector<Vec3> stretch_;        // per spring: h^2 k (x_b - x_a - d_s) [kg m]
  std::vector<Vec3> inertia_;        // M (y - x_n), with the attachment's force [kg m]
  std::vector<Vec3> move_;           // u = x - x_n [m]
  ScalarSystem::Columns rightSide_;  // [kg m]
  DiagonalChange attachment_;
};

/// Below the limit on (h omega)^2 the position error is up to three times that of the converged step
/// (docs/experiments/2026-11-22-solver-comparison.md).
std::optional<SolverWarning> localGlobalWarning(const ClothModel& model, const StepParameters& parameters) {
  constexpr double perIteration = 10.0;  // limit of (h omega)^2 [-]
  return slackWarning(model, parameters, perIteration);
}

}  // namespace

SolverInfo solvers::localGlobal() {
  return {
      .name = "local_global",
      .title = "Local/global springs",
      .help =
          "Backward Euler by alternating minimisation: first the direction of every spring, then all positions from a "
          "linear system with a constant matrix. An iteration costs one solve with a sparse factor. The factor is "
          "computed again when the time step, stiffness, damping, mass or pins change. It never blows up. With few "
          "iterations stiff cloth looks frozen and rotates too slowly: use more iterations or shorter steps.",
      .source = "Liu, Bargteil, O'Brien and Kavan (2013), Fast simulation of mass-spring systems",
      .backwardEuler = true,
      .settings = {"iterations"},
      .warning = localGlobalWarning,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<LocalGlobalSolver>(); }};
}

}  // namespace drape::sim
