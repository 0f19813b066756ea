#pragma once

#include "sim/diagonal_change.hpp"
#include "sim/scalar_system.hpp"
#include "sim/vector.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// What the hand adds to the diagonal of the filter's matrix.
struct AttachmentDiagonal {
  std::array<std::size_t, 3> vertices{};  ///< the corners that it holds
  Vec3 additions = Vec3::Zero();          ///< h^2 w_c times its stiffness [kg]
};

/// The constant filter of Desbrun, Schroeder and Barr (1999): backward Euler for springs of which only the scalar part
/// k of the derivative is kept has the same matrix at every step, and its inverse, worked out beforehand, takes from
/// the forces what the step could not carry. In print, for equal masses, Ff = W F with W = (I - h^2/m H)^-1; for masses
/// that differ, Ff = M A^-1 F with A = M - h^2 H = M + sum_s w_s L_s, which is the same where they do not. Without pins
/// the forces' sum stays what it was.
///
/// The inverse is kept as the dense matrix that was published up to `largestDense` vertices (8 n^2 bytes), as a sparse
/// Cholesky factor above.
class ConstantFilter {
 public:
  static constexpr std::size_t largestDense = 4096;

  /// @param largest up to how many free vertices the inverse is dense
  explicit ConstantFilter(std::size_t largest = largestDense) : largest_(largest) {}

  /// Makes the filter that of the given model and weight.
  /// @param hand what is added to the diagonal of A, or nullptr
  void prepare(const ClothModel& model, const ScalarWeight& weight, const AttachmentDiagonal* attachment);

  /// Replaces impulses h F [N s], one a vertex, by the velocity changes A^-1 h F = h M^-1 Ff [m/s]; zero where pinned.
  void apply(int threads, Workers& workers, std::vector<Vec3>& impulses);

 private:
  [[nodiscard]] bool dense() const { return system_.vertices().size() <= largest_; }
  void invert();
  void multiply(int threads, Workers& workers);

  std::size_t largest_;
  ScalarSystem system_;
  DiagonalChange attachment_;
  Eigen::MatrixXd inverse_;         // A^-1 [1/kg], symmetric; empty where the factor is used
  ScalarSystem::Columns impulses_;  // [N s]
  ScalarSystem::Columns changes_;   // of the velocities [m/s]
};

}  // namespace drape
