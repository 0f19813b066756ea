#include "sim/measures/equilibrium.hpp"

#include "sim/forces/step_inputs.hpp"
#include "sim/model/workers.hpp"
#include "sim/systems/fabric_energy.hpp"
#include "sim/systems/line_search.hpp"
#include "sim/systems/sparse_system.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

constexpr double roundingUnit = std::numeric_limits<double>::epsilon();
/// Added to the second derivative, as a fraction of its largest diagonal entry. It holds vertices that no force holds
/// (fabric without bending) and does not change the equilibrium. It lets neutral modes count as stable.
constexpr double regularisation = 1e-14;
/// The largest residual, relative to the load, that rounding may excuse [-]. The bound of the rounding errors grows
/// with the displacement. Without a limit it would exceed the load on a cloth that falls for ever.
constexpr double largestExcuse = 1e-5;

/// The sum of the sizes of the terms of the bending energy at rest [J]. They cancel there, and nearly so in bent cloth.
double sizeOfBendingTerms(const ClothModel& model) {
  const fabric::VertexMatrix& bending = model.fabric->bending;
  double size = 0.0;
  for (int row = 0; row < bending.outerSize(); ++row) {
    for (fabric::VertexMatrix::InnerIterator entry(bending, row); entry; ++entry) {
      const Vec3 offset = model.restPositions[entry.col()] - model.restPositions[row];
      size += 0.25 * std::abs(entry.value()) * offset.squaredNorm();
    }
  }
  return size;
}

/// The potential energy of a cloth under constant loads, as a function of the displacement from a start.
class StaticPotential {
 public:
  StaticPotential(const ClothModel& model, std::span<const Vec3> loads, std::span<const Vec3> start)
      : model_(model),
        loads_(loads),
        hessian_(model),
        bendingSize_(sizeOfBendingTerms(model)),
        gradient_(start.size()) {
    energy_.prepare(model, start, 1, workers_);
    if (hessian_.lower().rows() > 0) {
      cholesky_.analyzePattern(hessian_.lower());
    }
  }

  /// Computes value and gradient [N] with a fraction of the load.
  PotentialValue evaluate(const std::vector<Vec3>& displacement, double loadShare) {
    energy_.evaluate(displacement);
    double work = 0.0;
    double workSize = 0.0;
    double residual = 0.0;
    double rounding = 0.0;
    for (std::size_t v = 0; v < gradient_.size(); ++v) {
      gradient_[v].setZero();
      if (model_.pinned[v]) {
        continue;
      }
      const Vec3 load = loadShare * loads_[v];
      gradient_[v] = -energy_.forceOn(v) - load;
      work += load.dot(displacement[v]);
      workSize += load.norm() * displacement[v].norm();
      residual += gradient_[v].squaredNorm();
      const double size = energy_.forceSizeOn(v) + load.norm();
      rounding += size * size;
    }
    const double elastic = energy_.energy();
    return {.value = elastic - work,
            .valueRounding = roundingUnit * (16.0 * (elastic + workSize) + bendingSize_),
            .residual = std::sqrt(residual),
            .rounding = roundingUnit * std::sqrt(rounding)};
  }

  /// Newton's direction from the last evaluation. Returns the slope of the potential along it [J], which is negative;
  /// 0 if there is none.
  double findDirection(std::vector<Vec3>& direction) {
    if (!factorise(ForceDerivative::Exact) && !factorise(ForceDerivative::Stabilised)) {
      return 0.0;
    }
    const Eigen::VectorXd gradient = hessian_.gather(gradient_);
    const Eigen::VectorXd numbers = cholesky_.solve(-gradient);
    hessian_.scatter(numbers, direction);
    return std::min(0.0, gradient.dot(numbers));
  }

  /// Factorises the second derivative at the last evaluation. False if it has a negative eigenvalue.
  bool factorise(ForceDerivative variant) {
    if (hessian_.lower().rows() == 0) {
      return true;  // all vertices are pinned
    }
    diagonal_.assign(gradient_.size(), Mat3::Zero());
    pairs_.assign(model_.fabric->pairs.size(), Mat3::Zero());
    energy_.addDerivative(variant, 1.0, diagonal_, pairs_);
    double largest = 0.0;
    for (const Mat3& block : diagonal_) {
      largest = std::max(largest, block.diagonal().maxCoeff());
    }
    for (Mat3& block : diagonal_) {
      block.diagonal().array() += regularisation * largest;
    }
    hessian_.fill(model_, 1, workers_, diagonal_, pairs_);
    cholesky_.factorize(hessian_.lower());
    return cholesky_.info() == Eigen::Success;
  }

 private:
  const ClothModel& model_;
  std::span<const Vec3> loads_;
  Workers workers_;
  FabricEnergy energy_;
  SparseSystem hessian_;
  Eigen::SimplicialLLT<SparseSystem::Matrix, Eigen::Lower> cholesky_;
  double bendingSize_;          // [J]
  std::vector<Vec3> gradient_;  // [N]
  std::vector<Mat3> diagonal_;  // [N/m]
  std::vector<Mat3> pairs_;     // [N/m]
};

/// Newton's method on the potential, with the load in one or more steps.
class EquilibriumSearch {
 public:
  EquilibriumSearch(const ClothModel& model, std::span<const Vec3> loads, std::span<const Vec3> start,
                    const EquilibriumOptions& options, const std::stop_token& stop)
      : potential_(model, loads, start),
        options_(options),
        stop_(stop),
        displacement_(start.size(), Vec3::Zero()),
        direction_(start.size()),
        trial_(start.size()) {
    double squares = 0.0;
    for (std::size_t v = 0; v < start.size(); ++v) {
      squares += model.pinned[v] ? 0.0 : loads[v].squaredNorm();
    }
    const PotentialValue atStart = potential_.evaluate(displacement_, 0.0);
    scale_ = std::max(std::sqrt(squares), atStart.residual);
    largestRounding_ = std::max(largestExcuse * scale_, 2.0 * atStart.rounding);
  }

  Equilibrium run(std::span<const Vec3> start) {
    // Without load steps a search takes at most a fourth of the iterations.
    Equilibrium found;
    found.converged = minimise(1.0, options_.maxIterations / 4);
    if (!found.converged) {
      found.loadSteps = 0;
      found.converged = loadInSteps(found.loadSteps);
    }
    found.iterations = iterations_;
    found.residual = scale_ > 0.0 ? current_.residual / scale_ : 0.0;
    found.stable = found.converged && potential_.factorise(ForceDerivative::Exact);
    found.positions.assign(start.begin(), start.end());
    for (std::size_t v = 0; v < displacement_.size(); ++v) {
      found.positions[v] += displacement_[v];
    }
    return found;
  }

 private:
  /// Applies the load in steps that grow after a success and shrink after a failure.
  bool loadInSteps(int& steps) {
    std::fill(displacement_.begin(), displacement_.end(), Vec3::Zero());
    double applied = 0.0;
    double step = 0.1;
    while (applied < 1.0) {
      const std::vector<Vec3> before = displacement_;
      const double next = std::min(1.0, applied + step);
      if (minimise(next, iterations_ + options_.maxIterations / 8)) {
        applied = next;
        step *= 2.0;
        ++steps;
        continue;
      }
      step *= 0.25;
      if (step < options_.minLoadStep || iterations_ >= options_.maxIterations) {
        return minimise(1.0, options_.maxIterations);
      }
      displacement_ = before;
    }
    return true;
  }

  /// Minimises the potential with a fraction of the load. @param limit on the count of all iterations
  bool minimise(double loadShare, int limit) {
    const auto evaluate = [&](const std::vector<Vec3>& displacement) {
      return potential_.evaluate(displacement, loadShare);
    };
    current_ = evaluate(displacement_);
    const auto target = [&] {
      return std::max(options_.tolerance * scale_, std::min(current_.rounding, largestRounding_));
    };
    while (current_.residual > target() && iterations_ < std::min(limit, options_.maxIterations)) {
      if (stop_.stop_requested()) {
        throw StepStopped();
      }
      const double slope = potential_.findDirection(direction_);
      if (!(slope < 0.0) || !searchLine(evaluate, direction_, slope, displacement_, current_, trial_)) {
        break;
      }
      ++iterations_;
    }
    return current_.residual <= target();
  }

  StaticPotential potential_;
  const EquilibriumOptions& options_;
  const std::stop_token& stop_;
  PotentialValue current_;
  double scale_ = 0.0;            // of the residual [N]
  double largestRounding_ = 0.0;  // residual that may count as rounding [N]
  int iterations_ = 0;
  std::vector<Vec3> displacement_;  // from the start [m]
  std::vector<Vec3> direction_;     // [m]
  std::vector<Vec3> trial_;         // [m]
};

}  // namespace

Equilibrium equilibriumUnder(const ClothModel& model, std::span<const Vec3> loads, std::span<const Vec3> start,
                             const EquilibriumOptions& options, const std::stop_token& stop) {
  return EquilibriumSearch(model, loads, start, options, stop).run(start);
}

std::vector<Vec3> weightsOf(const ClothModel& model, double gravity) {
  std::vector<Vec3> weights;
  weights.reserve(model.vertexMass.size());
  for (const double mass : model.vertexMass) {
    weights.emplace_back(0.0, -mass * gravity, 0.0);
  }
  return weights;
}

bool isStableAt(const ClothModel& model, std::span<const Vec3> positions) {
  const std::vector<Vec3> none(positions.size(), Vec3::Zero());
  StaticPotential potential(model, none, positions);
  static_cast<void>(potential.evaluate(none, 0.0));
  return potential.factorise(ForceDerivative::Exact);
}

}  // namespace drape::sim
