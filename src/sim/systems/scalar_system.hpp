#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/model_cache.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

namespace drape::sim {

/// The weight of a spring in a constant matrix, w = h^2 k + h C_d [kg].
struct ScalarWeight {
  double timeStep = 0.0;   ///< h [s]
  double stiffness = 0.0;  ///< k of a spring of relative stiffness 1 [N/m]
  double damping = 0.0;    ///< C_d [N s/m]

  [[nodiscard]] double of(const Spring& spring) const {
    return timeStep * (timeStep * (stiffness * spring.relativeStiffness) + damping);
  }
  [[nodiscard]] bool operator==(const ScalarWeight&) const = default;
};

/// The constant matrix A = M + sum_s w_s L_s with one row a vertex, and its Cholesky factor. M are the masses, L_s is
/// the Laplacian of one spring (1 on the diagonals of its ends, -1 between them) and w_s its weight. It is the matrix
/// of backward Euler for springs without rest length; x, y and z are solved separately. Pinned vertices have neither
/// row nor column, but count on the diagonals of their neighbours.
///
/// It is factored again only when the weight or the model changes, and ordered again only when the model changes.
class ScalarSystem {
 public:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;  ///< x, y, z; one row a free vertex

  /// Computes the factor for the given model and weight, if necessary. True if it was computed.
  bool prepare(const ClothModel& model, const ScalarWeight& weight);

  /// The free vertices, ascending: the vertex of each row.
  [[nodiscard]] const std::vector<std::size_t>& vertices() const { return pattern_->vertices; }
  /// The row of each vertex, -1 if it is pinned.
  [[nodiscard]] const std::vector<int>& rows() const { return pattern_->rows; }

  /// A^-1 b. NaN if A could not be factored, as with infinite stiffness.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rightSides) const;

 private:
  using Factor = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>;

  struct Pattern {
    std::vector<std::size_t> vertices;
    std::vector<int> rows;
    std::unique_ptr<Factor> factor;
    bool factored = false;
    std::optional<ScalarWeight> weight;  // of the factor
  };

  static Pattern patternOf(const ClothModel& model);

  ModelCache<Pattern> patterns_;
  const Pattern* pattern_ = nullptr;  // of the last `prepare`
};

}  // namespace drape::sim
