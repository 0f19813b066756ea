#include "sim/forces/external_forces.hpp"
#include "sim/forces/kernels.hpp"
#include "sim/model/workers.hpp"
#include "sim/solvers/common_warnings.hpp"
#include "sim/solvers/registry.hpp"

namespace drape::sim {
namespace {

/// The direct update of Kang, Choi, Cho and Lee (2001): backward Euler with the scalar derivative k I and one explicit
/// iteration. No matrix is left, and every vertex divides by one number.
///
///     F~_i = F_i + h sum_j k (v_j - v_i)
///     dv_i = [h F~_i + h^2 sum_j k h F~_j / (m_j + h^2 k n_j)] / (m_i + h^2 k n_i)
///
/// then v += dv, x += h v. It equals the solver one_iteration with one sweep and the derivative `scalar`, in cheaper
/// loops that divide by scalars.
///
/// Choices that the paper leaves open:
/// - Damping -C_d (v_i - v_j) is part of F, and implicit: n_i h C_d joins the denominators, h C_d the coupling h^2 k.
/// - A pinned vertex has dv = 0 and F~ = 0; its springs still count in the denominators of its neighbours.
/// - Masses may differ: m_i replaces the single mass of the paper.
/// - Gravity, air and attachment are part of F, so they are filtered like the springs. The attachment's stiffness is
///   distributed over the corners of its triangle and joins their denominators.
class KangSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    const std::size_t count = state.positions.size();
    pull_.resize(model.springs.size());
    denominator_.resize(count);
    p_.resize(count);
    workers_.forEach(parameters.threads, model.springs.size(),
                     [&](std::size_t s) { evaluateSpring(model, parameters, state, s); });
    workers_.forEach(parameters.threads, count, [&](std::size_t i) { start(model, parameters, state, i); });
    if (inputs.attachment) {
      addAttachment(model, parameters.timeStep, attachmentForce(model, *inputs.attachment, state));
    }
    workers_.forEach(parameters.threads, count, [&](std::size_t i) { finish(model, parameters, state, i); });
    state.time += parameters.timeStep;
    return {};
  }

 private:
  /// h^2 k + h C_d, the coupling of a spring's ends [kg].
  static double couplingOf(const ClothModel& model, const StepParameters& parameters, const SpringEnd& end) {
    const double h = parameters.timeStep;
    const double relative = model.springs[static_cast<std::size_t>(end.spring)].relativeStiffness;
    return h * (h * (parameters.material.stiffness * relative) + parameters.material.damping);
  }

  /// The spring's part of F~ on its first end: force, damping and h k (v_b - v_a).
  void evaluateSpring(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                      std::size_t s) {
    const Spring& spring = model.springs[s];
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const double stiffness = parameters.material.stiffness * spring.relativeStiffness;
    const double viscosity = parameters.material.damping + parameters.timeStep * stiffness;
    pull_[s] = kernels::springForce(state.positions[b] - state.positions[a], spring.restLength, stiffness) +
               viscosity * (state.velocities[b] - state.velocities[a]);
  }

  /// p_i = h F~_i / (m_i + h^2 k n_i + h C_d n_i).
  void start(const ClothModel& model, const StepParameters& parameters, const ClothState& state, std::size_t i) {
    Vec3 force = gravityAndAir(model, parameters, state, i);
    double denominator = model.vertexMass[i];
    for (const SpringEnd& spring : model.springEnds[i]) {
      // Neighbours ascend, so the sign is that of (neighbour - i): a spring's first end is the lower one.
      const Vec3& pull = pull_[static_cast<std::size_t>(spring.spring)];
      if (spring.neighbour > static_cast<int>(i)) {
        force += pull;
      } else {
        force -= pull;
      }
      denominator += couplingOf(model, parameters, spring);
    }
    denominator_[i] = denominator;
    p_[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : Vec3((parameters.timeStep / denominator) * force);
  }

  void addAttachment(const ClothModel& model, double h, const AttachmentForce& pull) {
    const Vec3 force = pull.implicitForce(h);
    pull.forEach([&](std::size_t v, double weight) {
      if (!model.pinned[v]) {
        const Vec3 impulse = denominator_[v] * p_[v] + (h * weight) * force;
        denominator_[v] += h * h * weight * pull.stiffness;
        p_[v] = impulse / denominator_[v];
      }
    });
  }

  /// dv_i = p_i + (h^2 k + h C_d) sum_j p_j / denominator_i; v += dv, x += h v.
  void finish(const ClothModel& model, const StepParameters& parameters, ClothState& state, std::size_t i) const {
    if (model.pinned[i]) {
      state.velocities[i].setZero();
      return;
    }
    Vec3 sum = Vec3::Zero();
    for (const SpringEnd& spring : model.springEnds[i]) {
      sum += couplingOf(model, parameters, spring) * p_[static_cast<std::size_t>(spring.neighbour)];
    }
    state.velocities[i] += p_[i] + sum / denominator_[i];
    state.positions[i] += parameters.timeStep * state.velocities[i];
  }

  Workers workers_;
  std::vector<Vec3> pull_;           // per spring, on its first end [N]
  std::vector<double> denominator_;  // [kg]
  std::vector<Vec3> p_;              // h F~_i over the denominator [m/s]; zero where pinned
};

}  // namespace

SolverInfo solvers::kang() {
  return {.name = "kang",
          .title = "Kang direct update",
          .help =
              "Backward Euler with the spring constant as the whole force derivative and one explicit iteration: no "
              "matrix, one division a vertex. The cheapest implicit step, and very stable. Folding meets as much "
              "resistance as stretching, so cloth moves too slowly. Best with small steps and soft springs.",
          .source = "Kang, Choi, Cho and Lee (2001), in The Visual Computer 17",
          .backwardEuler = true,
          .settings = {},
          .warning = stiffFoldsWarning,
          .make = []() -> std::unique_ptr<Solver> { return std::make_unique<KangSolver>(); }};
}

}  // namespace drape::sim
