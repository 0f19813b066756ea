#include "sim/systems/diagonal_change.hpp"

#include <Eigen/LU>

namespace drape::sim {

void DiagonalChange::clear() {
  active_ = false;
  known_ = false;
}

void DiagonalChange::set(const ScalarSystem& system, bool changed, const std::array<std::size_t, 3>& vertices,
                         const Vec3& additions) {
  if (!known_ || changed || vertices_ != vertices) {
    vertices_ = vertices;
    findColumns(system);
    known_ = true;
  }
  active_ = !rows_.empty();
  additions_.resize(static_cast<Eigen::Index>(rows_.size()));
  for (Eigen::Index c = 0; c < additions_.size(); ++c) {
    additions_[c] = additions[corners_[c]];
  }
}

void DiagonalChange::findColumns(const ScalarSystem& system) {
  rows_.clear();
  corners_.clear();
  for (std::size_t c = 0; c < vertices_.size(); ++c) {
    if (const int row = system.rows()[vertices_[c]]; row >= 0) {
      rows_.push_back(row);
      corners_.push_back(static_cast<Eigen::Index>(c));
    }
  }
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(system.vertices().size()),
                                                static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t c = 0; c < rows_.size(); ++c) {
    units(rows_[c], static_cast<Eigen::Index>(c)) = 1.0;
  }
  columns_ = rows_.empty() ? units : system.solve(units);
}

void DiagonalChange::applyTo(ScalarSystem::Columns& answer) const {
  if (!active_) {
    return;
  }
  const Eigen::Index count = columns_.cols();
  Eigen::MatrixXd rightSide(count, 3);
  Eigen::MatrixXd small = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const int row = rows_[r];
    rightSide.row(r) = answer.row(row);
    small.row(r) += columns_.row(row).cwiseProduct(additions_.transpose());
  }
  const Eigen::MatrixXd solution = small.partialPivLu().solve(rightSide);
  for (Eigen::Index c = 0; c < count; ++c) {
    answer -= columns_.col(c) * (additions_[c] * solution.row(c));
  }
}

}  // namespace drape::sim
