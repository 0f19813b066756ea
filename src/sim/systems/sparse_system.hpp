#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/workers.hpp"

#include <Eigen/SparseCore>
#include <vector>

namespace drape::sim {

/// A symmetric 3n x 3n matrix with a 3x3 block for each of the n free vertices and for each pair of them that acts on
/// each other: each spring, or each pair of a fabric (fabric::Fabric::pairs). Pinned vertices have neither rows nor
/// columns. The sparsity pattern is computed once for a model; `fill` overwrites the values.
class SparseSystem {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit SparseSystem(const ClothModel& model);

  /// The lower triangle, column-major.
  [[nodiscard]] const Matrix& lower() const { return lower_; }

  /// Sets all blocks: `diagonal` one a vertex, symmetric, and `pairBlocks` one a spring or pair, with the rows of its
  /// second vertex and the columns of its first.
  void fill(const ClothModel& model, int threads, Workers& workers, const std::vector<Mat3>& diagonal,
            const std::vector<Mat3>& pairBlocks);

  /// Adds to the block of two vertices that are equal or a pair, and to its mirror image. `block` is symmetric.
  /// Does nothing if either is pinned.
  void add(const ClothModel& model, std::size_t vertex, std::size_t other, const Mat3& block);

  /// Converts between one vector a vertex and the 3n numbers of the free vertices. `scatter` sets pinned ones to zero.
  [[nodiscard]] Eigen::VectorXd gather(const std::vector<Vec3>& vectors) const;
  void scatter(const Eigen::VectorXd& numbers, std::vector<Vec3>& vectors) const;

 private:
  void fillVertex(const ClothModel& model, std::size_t vertex, const std::vector<Mat3>& diagonal,
                  const std::vector<Mat3>& pairBlocks);
  void reserve(const ClothModel& model);
  void writePattern(const ClothModel& model);
  /// True if that pair of `vertex` has a block below the diagonal in the vertex's columns.
  [[nodiscard]] bool isBelow(std::size_t vertex, const SpringEnd& end) const;

  std::vector<int> row_;  // first row of each vertex / 3; -1: pinned
  Matrix lower_;
};

}  // namespace drape::sim
