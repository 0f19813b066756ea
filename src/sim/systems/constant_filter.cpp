#include "sim/systems/constant_filter.hpp"

#include <algorithm>

namespace drape::sim {
namespace {

/// Number of columns solved at once, and of rows multiplied at once, so that both stay in the cache.
constexpr Eigen::Index blockSize = 128;

}  // namespace

void ConstantFilter::prepare(const ClothModel& model, const ScalarWeight& weight,
                             const AttachmentDiagonal* attachment) {
  const bool changed = system_.prepare(model, weight);
  if (!dense()) {
    inverse_.resize(0, 0);
  } else if (changed) {
    invert();
  }
  if (attachment == nullptr) {
    attachment_.clear();
  } else {
    attachment_.set(system_, changed, attachment->vertices, attachment->additions);
  }
}

void ConstantFilter::apply(int threads, Workers& workers, std::vector<Vec3>& impulses) {
  const std::vector<std::size_t>& vertices = system_.vertices();
  const auto size = static_cast<Eigen::Index>(vertices.size());
  impulses_.resize(size, 3);
  changes_.resize(size, 3);
  for (Eigen::Index row = 0; row < size; ++row) {
    impulses_.row(row) = impulses[vertices[row]].transpose();
  }
  if (dense()) {
    multiply(threads, workers);
  } else {
    changes_ = system_.solve(impulses_);
  }
  attachment_.applyTo(changes_);
  std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  for (Eigen::Index row = 0; row < size; ++row) {
    impulses[vertices[row]] = changes_.row(row).transpose();
  }
}

void ConstantFilter::invert() {
  const auto size = static_cast<Eigen::Index>(system_.vertices().size());
  inverse_.resize(size, size);
  for (Eigen::Index first = 0; first < size; first += blockSize) {
    const Eigen::Index count = std::min(blockSize, size - first);
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(size, count);
    units.middleRows(first, count).setIdentity();
    inverse_.middleCols(first, count) = system_.solve(units);
  }
}

/// The sum of each row runs over the columns in order, so it does not depend on the number of threads.
void ConstantFilter::multiply(int threads, Workers& workers) {
  const Eigen::Index size = inverse_.rows();
  workers.forRange(threads, static_cast<int>(size), [&](int begin, int end) {
    for (Eigen::Index first = begin; first < end; first += blockSize) {
      const Eigen::Index count = std::min<Eigen::Index>(blockSize, end - first);
      auto sums = changes_.middleRows(first, count);
      sums.setZero();
      for (Eigen::Index column = 0; column < size; ++column) {
        const auto factors = inverse_.col(column).segment(first, count);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
          sums.col(axis) += impulses_(column, axis) * factors;
        }
      }
    }
  });
}

}  // namespace drape::sim
