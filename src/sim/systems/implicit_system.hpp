#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/workers.hpp"
#include "sim/systems/fabric_energy.hpp"

#include <vector>

namespace drape::sim {

/// The linear system of one backward-Euler step, W dv = h f~ with W = M - h^2 J and f~ = f + h J v (eqs. 5-9), with the
/// damping of eqs. 12-14. It consists of 3x3 blocks. The matrix is not assembled: the blocks J_ij are stored per
/// spring, or per pair of a fabric (fabric::Fabric::pairs), which has no damping.
///
/// | here           | paper                                                              |
/// |----------------|--------------------------------------------------------------------|
/// | diagonal       | W'_ii = M_i + h^2 sum_j J_ij + n_i h C_d I (eqs. 10, 13)           |
/// | coupling       | h^2 sum_j J'_ij dv_j, J'_ij = J_ij + (C_d / h) I (eqs. 11, 13)     |
/// | rightHandSide  | h f~_i, with gravity, springs, damping, air, attachment (eqs. 8, 14) |
///
/// A pinned vertex has dv = 0; the solver must ensure that. The attachment's stiffness is lumped on the diagonal.
class ImplicitSystem {
 public:
  /// Computes the system at the given state.
  void assemble(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                const ClothState& state, Workers& workers);

  /// W'_ii, one a vertex [kg].
  [[nodiscard]] const std::vector<Mat3>& diagonal() const { return diagonal_; }
  /// What block Jacobi adds to the diagonal blocks of a fabric, one a vertex [kg]. The iteration with the blocks W'_ii
  /// themselves would diverge for stiff fabrics. With W'_ii + S_ii the eigenvalues of the iteration are at least -1, as
  /// those of springs are: a triangle's derivative is at most three times its diagonal blocks, and a row of the bending
  /// matrix at most the sum of its absolute values.
  [[nodiscard]] const std::vector<Mat3>& jacobiSurplus() const { return surplus_; }
  /// h f~_i, one a vertex [N s].
  [[nodiscard]] const std::vector<Vec3>& rightHandSide() const { return rightHandSide_; }
  /// h^2 sum_j J'_ij dv_j, the contribution of vertex i's neighbours to its row [N s].
  [[nodiscard]] Vec3 coupling(const ClothModel& model, const CommonParameters& parameters, const std::vector<Vec3>& dv,
                              std::size_t vertex) const;

  /// Row i of W dv [N s].
  [[nodiscard]] Vec3 row(const ClothModel& model, const CommonParameters& parameters, const std::vector<Vec3>& dv,
                         std::size_t vertex) const {
    return diagonal_[vertex] * dv[vertex] - coupling(model, parameters, dv, vertex);
  }

 private:
  void assembleSprings(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                       Workers& workers);
  void assembleFabric(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                      Workers& workers);
  void evaluateSpring(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                      std::size_t spring);
  void assembleVertex(const ClothModel& model, const CommonParameters& parameters, const ClothState& state,
                      std::size_t vertex);
  void addAttachment(const ClothModel& model, double timeStep, const Attachment& attachment, const ClothState& state);

  /// sum_j J_ij v_j over the neighbours of a vertex in a fabric [N/s for velocities].
  [[nodiscard]] Vec3 elasticCoupling(const ClothModel& model, const std::vector<Vec3>& vectors,
                                     std::size_t vertex) const;

  std::vector<Mat3> pairBlocks_;  // J_ij of springs; of a fabric's pairs with the rows of the second vertex [N/m]
  FabricEnergy fabric_;
  std::vector<Vec3> springForces_;  // per spring, on its first end: elastic, damping and its part of h J v [N]
  std::vector<Mat3> diagonal_;
  std::vector<Mat3> surplus_;
  std::vector<Vec3> rightHandSide_;
};

/// Ends a backward-Euler step with the velocity change dv: v += dv, x += h v. Pinned vertices stay, with zero velocity.
void advance(const ClothModel& model, double timeStep, const std::vector<Vec3>& dv, ClothState& state);

}  // namespace drape::sim
