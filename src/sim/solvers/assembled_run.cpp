#include "sim/solvers/assembled_run.hpp"

#include "sim/solvers/conjugate_gradients_loop.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace drape::sim {
namespace {

/// The inverse of a diagonal block, or of its norm times the identity if it is not positive definite, which the exact
/// derivative allows.
Mat3 inverseOf(const Mat3& block) {
  const Eigen::LDLT<Mat3> factors(block);
  if (factors.info() == Eigen::Success && factors.isPositive() && (factors.vectorD().array() > 0.0).all()) {
    return block.inverse();
  }
  return Mat3::Identity() / block.norm();
}

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].dot(b[i]);
  }
  return sum;
}

}  // namespace

/// The vectors of a solve by conjugate gradients. simd/conjugate_gradients_kernel.cpp has those of springs.
struct AssembledRun::ConjugateVectors {
  [[nodiscard]] double squaredResidual() const { return dot(run.residual_, run.residual_); }
  [[nodiscard]] double descent() const { return dot(run.residual_, run.scaled_); }

  double multiply() {
    run.workers_.forEach(parameters.threads, run.product_.size(), [this](std::size_t i) {
      run.product_[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : run.system_.row(model, parameters, run.direction_, i);
    });
    return dot(run.direction_, run.product_);
  }

  void descend(double length) {
    for (std::size_t i = 0; i < run.change_.size(); ++i) {
      run.change_[i] += length * run.direction_[i];
      run.residual_[i] -= length * run.product_[i];
      run.scaled_[i] = run.inverses_[i] * run.residual_[i];
    }
  }

  void turn(double factor) {
    for (std::size_t i = 0; i < run.direction_.size(); ++i) {
      run.direction_[i] = run.scaled_[i] + factor * run.direction_[i];
    }
  }

  AssembledRun& run;
  const ClothModel& model;
  const StepParameters& parameters;
};

void AssembledRun::assemble(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                            const ClothState& state, bool withSurplus) {
  const std::size_t count = state.positions.size();
  system_.assemble(model, parameters, inputs, state, workers_);
  inverses_.resize(count);
  start_.resize(count);
  workers_.forEach(parameters.threads, count, [&](std::size_t i) {
    const Mat3 block = withSurplus ? Mat3(system_.diagonal()[i] + system_.jacobiSurplus()[i]) : system_.diagonal()[i];
    inverses_[i] = model.pinned[i] ? Mat3(Mat3::Zero()) : inverseOf(block);
    start_[i] = inverses_[i] * system_.rightHandSide()[i];
  });
}

void AssembledRun::oneIteration(const ClothModel& model, const CommonParameters& parameters,
                                const simd::JacobiOptions& jacobi, const StepInputs& inputs, int count,
                                const std::vector<double>& weights, ClothState& state) {
  for (int step = 0; step < count; ++step) {
    assemble(model, parameters, inputs, state, true);
    // Damped Jacobi starts from the relaxed p. Weights exclude relaxation.
    before_.assign(start_.size(), Vec3::Zero());
    change_ = start_;
    for (Vec3& change : change_) {
      change *= jacobi.relaxation;
    }
    for (int i = 1; i <= jacobi.sweeps; ++i) {
      sweep(model, parameters, jacobi, i, weights);
    }
    advance(model, parameters.timeStep, change_, state);
  }
}

void AssembledRun::sweep(const ClothModel& model, const CommonParameters& parameters, const simd::JacobiOptions& jacobi,
                         int sweep, const std::vector<double>& weights) {
  const double weight = weights.empty() ? jacobi.relaxation : weights[static_cast<std::size_t>(sweep) - 1];
  product_.resize(start_.size());
  workers_.forEach(parameters.threads, start_.size(), [&](std::size_t i) {
    const Vec3 coupling = system_.coupling(model, parameters, change_, i) + system_.jacobiSurplus()[i] * change_[i];
    const Vec3 answer = inverses_[i] * coupling + start_[i];
    const Vec3& old = weights.empty() ? change_[i] : before_[i];
    product_[i] = weight * (answer - old) + old;
  });
  std::swap(before_, change_);
  std::swap(change_, product_);
}

StepReport AssembledRun::conjugateGradients(const ClothModel& model, const StepParameters& parameters,
                                            const StepInputs& inputs, int count, ClothState& state) {
  StepReport report;
  for (int step = 0; step < count; ++step) {
    assemble(model, parameters, inputs, state, false);
    report.add(solve(model, parameters));
    advance(model, parameters.timeStep, change_, state);
  }
  return report;
}

StepReport AssembledRun::solve(const ClothModel& model, const StepParameters& parameters) {
  const std::size_t count = start_.size();
  change_.assign(count, Vec3::Zero());
  residual_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    residual_[i] = model.pinned[i] ? Vec3(Vec3::Zero()) : system_.rightHandSide()[i];
  }
  scaled_ = start_;
  direction_ = start_;
  product_.resize(count);
  return sim::conjugateGradients(ConjugateVectors{*this, model, parameters}, parameters.iteration);
}

}  // namespace drape::sim
