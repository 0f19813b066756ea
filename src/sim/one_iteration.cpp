#include "sim/one_iteration.hpp"

#include "sim/kernels.hpp"
#include "sim/normals.hpp"
#include "sim/workers.hpp"

#include <Eigen/LU>
#include <vector>

namespace drape {
namespace {

// | here             | paper                                                                |
// |------------------|----------------------------------------------------------------------|
// | h, k, C_d        | time step, spring stiffness, spring damping                          |
// | f                | f~ = f + h J v, with gravity, damping and air in f (eqs. 8, 14)      |
// | J                | J_ij of each spring (eq. 16)                                         |
// | W_inverse        | inverse of the 3x3 diagonal block W'_ii (eqs. 10, 13)                |
// | p                | p_i = h W_ii^-1 f~_i                                                 |
// | dv               | velocity change of the last sweep                                    |
class OneIterationSolver final : public Solver {
 public:
  void step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
            ClothState& state) override {
    resize(model);
    const int springs = static_cast<int>(model.springs.size());
    const int vertices = model.vertexCount();
    const auto each = [&](int count, auto&& visit) {
      workers_.forRange(parameters.threads, count, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          visit(static_cast<std::size_t>(i));
        }
      });
    };
    each(springs, [&](std::size_t s) { evaluateSpring(model, parameters, state, s); });
    each(vertices, [&](std::size_t i) { assembleVertex(model, parameters, state, i); });
    if (inputs.grab) {
      addGrab(model, parameters, *inputs.grab, state);
    }
    each(vertices, [&](std::size_t i) { startVertex(model, parameters, i); });
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep) {
      each(vertices, [&](std::size_t i) { sweepVertex(model, parameters, i); });
      dv_.swap(dvNext_);
    }
    each(vertices, [&](std::size_t i) { advanceVertex(model, parameters, i, state); });
    state.time += parameters.timeStep;
  }

 private:
  void resize(const ClothModel& model) {
    const auto vertices = static_cast<std::size_t>(model.vertexCount());
    J_.resize(model.springs.size());
    springForce_.resize(model.springs.size());
    f_.resize(vertices);
    W_.resize(vertices);
    p_.resize(vertices);
    dv_.resize(vertices);
    dvNext_.resize(vertices);
  }

  /// The elastic force on the spring's first end plus its share of h J v, and the block J_ij (eq. 16).
  void evaluateSpring(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                      std::size_t s) {
    const Spring& spring = model.springs[s];
    const auto a = static_cast<std::size_t>(spring.a);
    const auto b = static_cast<std::size_t>(spring.b);
    const Vec3 offset = state.positions[b] - state.positions[a];
    J_[s] = kernels::springDerivative(offset, spring.restLength, parameters.stiffness);
    springForce_[s] = kernels::springForce(offset, spring.restLength, parameters.stiffness) +
                      kernels::dampingForce(state.velocities[a], state.velocities[b], parameters.damping) +
                      parameters.timeStep * (J_[s] * (state.velocities[b] - state.velocities[a]));
  }

  /// f~_i (eqs. 8, 14, 18-20) and the diagonal block W'_ii = M_i + h^2 sum_j J_ij + n_i h C_d I (eqs. 10, 13).
  void assembleVertex(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                      std::size_t i) {
    const double h = parameters.timeStep;
    const double mass = model.vertexMass[i];
    Vec3 force(0.0, -mass * parameters.gravity, 0.0);
    Mat3 coupling = Mat3::Zero();
    const auto begin = static_cast<std::size_t>(model.springEnds.begin[i]);
    const auto end = static_cast<std::size_t>(model.springEnds.begin[i + 1]);
    for (std::size_t e = begin; e < end; ++e) {
      const SpringEnd& springEnd = model.springEnds.values[e];
      const auto s = static_cast<std::size_t>(springEnd.spring);
      const bool first = static_cast<int>(i) == model.springs[s].a;
      force += first ? springForce_[s] : Vec3(-springForce_[s]);
      coupling += J_[s];
    }
    f_[i] = force + air(model, parameters, state, i);
    const double isotropic = mass + static_cast<double>(end - begin) * h * parameters.damping;
    W_[i] = h * h * coupling + isotropic * Mat3::Identity();
  }

  [[nodiscard]] static Vec3 air(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                                std::size_t i) {
    if (parameters.drag == 0.0 && parameters.lift == 0.0) {
      return Vec3::Zero();
    }
    const double pressureArea = 0.5 * parameters.airDensity * model.vertexArea[i];
    return kernels::airForce(vertexNormal(model, state.positions, static_cast<int>(i)),
                             state.velocities[i] - parameters.wind, pressureArea * parameters.drag,
                             pressureArea * parameters.lift, model.vertexMass[i], parameters.timeStep);
  }

  /// The hand's spring pulls at a point of a triangle, so its corners share force and stiffness by their weights. Its
  /// stiffness enters W as that of the chord: where the force is bounded it is less than asked for.
  void addGrab(const ClothModel& model, const StepParameters& parameters, const Grab& grab, const ClothState& state) {
    const double h = parameters.timeStep;
    Vec3 point = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    const Triangle& corners = model.triangles[static_cast<std::size_t>(grab.triangle)];
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
      point += grab.barycentric[c] * state.positions[v];
      velocity += grab.barycentric[c] * state.velocities[v];
    }
    const Vec3 offset = grab.target - point;
    const double distance = offset.norm();
    const Vec3 force = kernels::boundedSpringForce(offset, grab.stiffness, grab.maxForce);
    const double chord = distance > 0.0 ? force.norm() / distance : grab.stiffness;
    for (int c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(corners[static_cast<std::size_t>(c)]);
      f_[v] += grab.barycentric[c] * (force - h * chord * velocity);
      W_[v] += (grab.barycentric[c] * h * h * chord) * Mat3::Identity();
    }
  }

  /// p_i = h W_ii^-1 f~_i, the start of the sweeps. A pinned vertex has no velocity to gain.
  void startVertex(const ClothModel& model, const StepParameters& parameters, std::size_t i) {
    W_[i] = model.pinned[i] ? Mat3(Mat3::Zero()) : Mat3(W_[i].inverse());
    p_[i] = parameters.timeStep * (W_[i] * f_[i]);
    dv_[i] = p_[i];
  }

  /// dv_i = p_i + h^2 W_ii^-1 sum_j J'_ij dv_j (eq. 11), J'_ij = J_ij + (C_d / h) I (eq. 13).
  void sweepVertex(const ClothModel& model, const StepParameters& parameters, std::size_t i) {
    const double h = parameters.timeStep;
    Vec3 elastic = Vec3::Zero();
    Vec3 damped = Vec3::Zero();
    const auto begin = static_cast<std::size_t>(model.springEnds.begin[i]);
    const auto end = static_cast<std::size_t>(model.springEnds.begin[i + 1]);
    for (std::size_t e = begin; e < end; ++e) {
      const SpringEnd& springEnd = model.springEnds.values[e];
      const Vec3& dv = dv_[static_cast<std::size_t>(springEnd.neighbour)];
      elastic += J_[static_cast<std::size_t>(springEnd.spring)] * dv;
      damped += dv;
    }
    dvNext_[i] = p_[i] + W_[i] * (h * h * elastic + h * parameters.damping * damped);
  }

  void advanceVertex(const ClothModel& model, const StepParameters& parameters, std::size_t i,
                     ClothState& state) const {
    if (model.pinned[i]) {
      state.velocities[i].setZero();
      return;
    }
    state.velocities[i] += dv_[i];
    state.positions[i] += parameters.timeStep * state.velocities[i];
  }

  Workers workers_;
  std::vector<Mat3> J_;            // per spring [N/m]
  std::vector<Vec3> springForce_;  // per spring, on its first end [N]
  std::vector<Vec3> f_;            // per vertex [N]
  std::vector<Mat3> W_;            // per vertex: the diagonal block [kg], then its inverse [1/kg]
  std::vector<Vec3> p_;            // per vertex [m/s]
  std::vector<Vec3> dv_;           // per vertex [m/s]
  std::vector<Vec3> dvNext_;       // per vertex [m/s]
};

}  // namespace

std::unique_ptr<Solver> makeOneIterationSolver() {
  return std::make_unique<OneIterationSolver>();
}

}  // namespace drape
