#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/model/vector.hpp"
#include "sim/model/workers.hpp"
#include "sim/systems/diagonal_change.hpp"
#include "sim/systems/scalar_system.hpp"

#include <vector>

namespace drape::sim {

/// The constant filter of Desbrun, Schroeder and Barr (1999). Backward Euler with the scalar part k of the spring
/// derivative has the same matrix at every step. Its precomputed inverse filters the forces. The paper has equal
/// masses: Ff = W F with W = (I - h^2/m H)^-1. For different masses Ff = M A^-1 F with A = M - h^2 H = M + sum_s w_s
/// L_s, which is the same for equal masses. Without pins the filter conserves the sum of the forces.
///
/// Up to `largestDense` free vertices the inverse is a dense matrix (8 n^2 bytes), as in the paper. Above that a sparse
/// Cholesky factor is used.
class ConstantFilter {
 public:
  static constexpr std::size_t largestDense = 4096;

  /// @param largest number of free vertices up to which the inverse is dense
  explicit ConstantFilter(std::size_t largest = largestDense) : largest_(largest) {}

  /// Computes the filter for the given model and weight, if they changed.
  /// @param attachment additions to the diagonal of A, or nullptr
  void prepare(const ClothModel& model, const ScalarWeight& weight, const AttachmentDiagonal* attachment);

  /// Replaces impulses h F [N s], one a vertex, by velocity changes A^-1 h F = h M^-1 Ff [m/s]; zero where pinned.
  void apply(int threads, Workers& workers, std::vector<Vec3>& impulses);

 private:
  [[nodiscard]] bool dense() const { return system_.vertices().size() <= largest_; }
  void invert();
  void multiply(int threads, Workers& workers);

  std::size_t largest_;
  ScalarSystem system_;
  DiagonalChange attachment_;
  Eigen::MatrixXd inverse_;         // A^-1 [1/kg], symmetric; empty if the factor is used
  ScalarSystem::Columns impulses_;  // [N s]
  ScalarSystem::Columns changes_;   // of the velocities [m/s]
};

}  // namespace drape::sim
