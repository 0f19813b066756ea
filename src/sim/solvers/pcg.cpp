#include "sim/implicit_system.hpp"
#include "sim/solvers/registry.hpp"

#include <Eigen/LU>
#include <cmath>

namespace drape {
namespace {

bool isPositiveDefinite(const Mat3& block) {
  return block(0, 0) > 0.0 && block.topLeftCorner<2, 2>().determinant() > 0.0 && block.determinant() > 0.0;
}

/// The inverse of a diagonal block. With an indefinite force derivative a block need not be positive definite, which a
/// preconditioner must be; its size alone is then taken.
Mat3 preconditionerOf(const Mat3& block) {
  return isPositiveDefinite(block) ? Mat3(block.inverse()) : Mat3(Mat3::Identity() / block.norm());
}

/// Summed in the vertices' order, so that the result does not depend on the number of threads.
double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].dot(b[i]);
  }
  return sum;
}

/// The modified conjugate gradient method of Baraff and Witkin (1998, sec. 5.3) on the system of the one-iteration
/// method, preconditioned by the 3x3 diagonal blocks. Pins are constraints of their filter: the rows of a pinned vertex
/// are left out, and its velocity change is zero.
///
/// | here       | Baraff and Witkin                              |
/// |------------|------------------------------------------------|
/// | dv         | Delta v, from zero                             |
/// | residual   | r = filter(b - A Delta v)                      |
/// | direction  | c                                              |
/// | product    | q = filter(A c)                                |
/// | scaled     | s = filter(P^-1 r), P the diagonal blocks of A |
///
/// It starts from zero: the last step's dv would be a better guess and yet lets the cloth explode, since what a stopped
/// iteration leaves over would be carried from step to step.
class PcgSolver final : public Solver {
 public:
  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override {
    system_.assemble(model, parameters, inputs, state, workers_);
    start(model, parameters.threads);
    const StepReport report = solve(model, parameters);
    advance(model, parameters.timeStep, dv_, state);
    return report;
  }

 private:
  void start(const ClothModel& model, int threads) {
    const std::size_t count = model.pinned.size();
    dv_.assign(count, Vec3::Zero());
    residual_.resize(count);
    scaled_.resize(count);
    product_.resize(count);
    preconditioner_.resize(count);
    workers_.forEach(threads, count, [&](std::size_t i) {
      const bool free = !model.pinned[i];
      preconditioner_[i] = free ? preconditionerOf(system_.diagonal()[i]) : Mat3(Mat3::Zero());
      residual_[i] = free ? system_.rightHandSide()[i] : Vec3(Vec3::Zero());
      scaled_[i] = preconditioner_[i] * residual_[i];
    });
    direction_ = scaled_;
  }

  StepReport solve(const ClothModel& model, const StepParameters& parameters) {
    const double first = std::sqrt(dot(residual_, residual_));
    StepReport report;
    if (first == 0.0) {
      return report;
    }
    report.residual = 1.0;
    double descent = dot(residual_, scaled_);
    while (report.residual > parameters.tolerance && report.iterations < parameters.maxIterations) {
      multiply(model, parameters);
      const double curvature = dot(direction_, product_);
      if (!(curvature > 0.0)) {
        break;  // the matrix is indefinite: along this direction there is no minimum to go to
      }
      descend(parameters.threads, descent / curvature);
      const double next = dot(residual_, scaled_);
      turn(parameters.threads, next / descent);
      descent = next;
      report.residual = std::sqrt(dot(residual_, residual_)) / first;
      ++report.iterations;
    }
    report.converged = report.residual <= parameters.tolerance;
    return report;
  }

  void multiply(const ClothModel& model, const StepParameters& parameters) {
    workers_.forEach(parameters.threads, product_.size(), [&](std::size_t i) {
      product_[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : system_.row(model, parameters, direction_, i);
    });
  }

  void descend(int threads, double length) {
    workers_.forEach(threads, dv_.size(), [&](std::size_t i) {
      dv_[i] += length * direction_[i];
      residual_[i] -= length * product_[i];
      scaled_[i] = preconditioner_[i] * residual_[i];
    });
  }

  void turn(int threads, double share) {
    workers_.forEach(threads, direction_.size(),
                     [&](std::size_t i) { direction_[i] = scaled_[i] + share * direction_[i]; });
  }

  Workers workers_;
  ImplicitSystem system_;
  std::vector<Mat3> preconditioner_;  // P^-1, one block a vertex [1/kg]; zero where pinned
  std::vector<Vec3> dv_;              // [m/s]
  std::vector<Vec3> residual_;        // [N s]
  std::vector<Vec3> scaled_;          // [m/s]
  std::vector<Vec3> direction_;       // [m/s]
  std::vector<Vec3> product_;         // [N s]
};

}  // namespace

SolverInfo solvers::pcg() {
  return {
      .name = "pcg",
      .title = "Conjugate gradients",
      .help =
          "Backward Euler whose linear system is solved by preconditioned conjugate gradients until its residual is "
          "small. What the one-iteration method approximates: bounded at any step and stiffness that was tried, at "
          "the cost of tens to thousands of sweeps a step, the more the stiffer and finer the cloth. With an exact "
          "derivative the system of compressed cloth may have no such solution; it then stops early.",
      .source = "Baraff and Witkin (1998), Large steps in cloth simulation",
      .backwardEuler = true,
      .settings = {"tolerance", "max_iterations", "derivative"},
      .warning = nullptr,
      .make = []() -> std::unique_ptr<Solver> { return std::make_unique<PcgSolver>(); }};
}

}  // namespace drape
