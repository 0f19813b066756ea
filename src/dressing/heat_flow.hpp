#pragma once

#include "sim/model/cloth_model.hpp"

#include <Eigen/Sparse>
#include <vector>

namespace drape::dressing {

/// Diffusion of values along a surface, by the heat equation with cotangent weights (Desbrun, Meyer, Schroeder and Barr
/// 1999, Implicit fairing of irregular meshes), in steps of backward Euler.
class HeatFlow {
 public:
  explicit HeatFlow(const sim::ClothMesh& surface);

  /// @param timeStep of the following steps [m^2]
  void setTimeStep(double timeStep);

  /// Three values a vertex after a step.
  [[nodiscard]] std::vector<Vec3> advance(const std::vector<Vec3>& values) const;

 private:
  Eigen::SparseMatrix<double> laplacian_;
  Eigen::VectorXd areas_;  // of the vertices [m^2]
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace drape::dressing
