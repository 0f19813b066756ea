#pragma once

#include "sim/fabric/membrane.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/ragged_rows.hpp"
#include "sim/model/workers.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// A fabric as constraints of XPBD (Macklin, Mueller and Chentanez 2016). Each triangle has two block constraints, with
/// exactly the energies of the fabric. All quantities are in double.
///
/// | symbol  | meaning                                                                             | unit    |
/// |---------|-------------------------------------------------------------------------------------|---------|
/// | C       | membrane: q of the three sides (MembraneTriangle), which are Green's strains in      | m^2     |
/// |         | another basis                                                                        |         |
/// | kappa   | bending: the curvature of the triangle, three vectors, linear in the positions       | 1/m     |
/// | K, A D  | inverse compliance of either, see MembraneTriangle and bendingMatrix                 |         |
/// | p_i     | displacement of vertex i by the membrane of one triangle so far in the step, times   | kg m    |
/// |         | the mass                                                                             |         |
/// | Lambda  | multipliers of a block, -h^2 times tensions or moments at the solution               |         |
///
/// The curvature is linear in the positions. So its block is eq. 18 of their paper for three constraints, with a
/// constant matrix.
///
/// The sides are not linear. Their paper sums up corrections along the gradients of different iterations, and neglects
/// the change of the gradient and the geometric stiffness (sec. 4). Then the limit of many iterations is not the
/// backward-Euler step where triangles turn. Here each block stores p, and replaces it in each iteration: with H = M +
/// h^2 times the geometric stiffness of tensile stress, for the three corners,
///
///     (I + h^2 K G^T H^-1 G) Lambda = -h^2 t + h^2 K G^T H^-1 p,   dx = H^-1 (G Lambda - p),   p += M dx
///
/// with t the tensions and G the gradient of C at the present positions. This is a Newton step on the energy of the one
/// triangle plus the inertia of its corners. In the first iteration p is zero and, without stress, H = M: eq. 18. In
/// the limit G Lambda = p, so x = y - h^2 M^-1 grad E(x), with y the predicted positions and E the energy: the
/// backward-Euler step. If dx would overshoot the minimum along its direction by more than its length, as in triangles
/// that have collapsed, it is halved.
class FabricConstraints {
 public:
  /// @param model must have a fabric and outlive this
  explicit FabricConstraints(const ClothModel& model);

  /// Begins a step: nothing is corrected yet. @param timeStep h [s]
  void begin(double timeStep);

  /// Corrects the positions by all constraints once, in the order of their colours. The result does not depend on the
  /// number of threads. @param positions one a vertex [m]
  void project(int threads, Workers& workers, std::span<Vec3> positions);

 private:
  /// The curvature that one vertex adds to a triangle, per displacement.
  struct CurvatureEntry {
    int vertex = 0;
    Vec3 weight = Vec3::Zero();  ///< of k_11, k_22 and 2 k_12 [1/m^2]
  };

  void prepareBending(const ClothModel& model);
  void projectMembrane(std::size_t triangle, std::span<Vec3> positions);
  void projectBending(std::size_t triangle, std::span<Vec3> positions);

  const ClothModel* model_ = nullptr;
  double timeStep_ = 0.0;
  std::vector<double> inverseMass_;              // [1/kg], one a vertex; 0 where pinned
  RaggedRows<int> membraneColours_;              // triangles
  std::vector<fabric::Corners> membraneMoment_;  // p of each triangle's corners, one a column [kg m]
  RaggedRows<int> bendingColours_;               // triangles; empty if the fabric does not resist bending
  RaggedRows<CurvatureEntry> curvatures_;        // of each triangle
  std::vector<Vec3> bendingStiffness_;           // the diagonal of A D, of each triangle [N m^3]
  std::vector<Mat3> curvatureMobility_;          // sum of w_i b_i b_i^T, b_i the weights of a vertex [1/(kg m^4)]
  std::vector<Mat3> response_;                   // (I + h^2 A D sum of w_i b_i b_i^T)^-1 [-]
  std::vector<Mat3> bendingMultipliers_;         // Lambda of each triangle, a row for each curvature [kg m^3]
};

}  // namespace drape::sim
