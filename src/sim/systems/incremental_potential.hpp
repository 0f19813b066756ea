#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/workers.hpp"
#include "sim/systems/fabric_energy.hpp"
#include "sim/systems/line_search.hpp"
#include "sim/systems/sparse_system.hpp"

#include <optional>
#include <vector>

namespace drape::sim {

/// The incremental potential of a nonlinear backward-Euler step, a function of the velocities v at its end:
///
///     Phi(v) = 1/2 (v - v0)^T M (v - v0) - h v.g + E(x0 + h v) + h C_d / 2 sum_ij |v_i - v_j|^2
///
/// E is the energy of springs or fabric, and attachment; g are gravity and air, evaluated at the start of the step. The
/// step is the minimum. The gradient is the residual of the step's equations, M (v - v0) - h f(x0 + h v, v).
///
/// Spring lengths are computed from their change since x0, not from positions. Positions near 1 m give a length to
/// about 1e-16 m only, and with stiff springs that error would exceed the tolerance of the solve.
class IncrementalPotential {
 public:
  /// Prepares a step from `state`. The arguments must outlive the step.
  void prepare(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
               const ClothState& state, Workers& workers);

  /// Computes value and gradient [N s]. `velocities` are zero where pinned.
  PotentialValue evaluate(const std::vector<Vec3>& velocities);

  /// The gradient of the last evaluation [N s], one a vertex, zero where pinned.
  [[nodiscard]] const std::vector<Vec3>& gradient() const { return gradient_; }

  /// Computes the second derivative at the last evaluation [kg], with the given variant of the spring derivative.
  void fillHessian(ForceDerivative variant, SparseSystem& hessian);

 private:
  void prepareSpring(std::size_t spring, const ClothState& state);
  void evaluateSpring(std::size_t spring, const std::vector<Vec3>& velocities);
  void evaluateFabric(const std::vector<Vec3>& velocities);
  void findSpringBlocks(ForceDerivative variant);
  void findFabricBlocks(ForceDerivative variant);
  void gatherVertex(std::size_t vertex, const std::vector<Vec3>& velocities);
  double addAttachment(const std::vector<Vec3>& velocities);
  [[nodiscard]] PotentialValue sum(const std::vector<Vec3>& velocities, double attachmentEnergy) const;

  const ClothModel* model_ = nullptr;
  const CommonParameters* parameters_ = nullptr;
  Workers* workers_ = nullptr;
  std::vector<Vec3> startVelocities_;  // v0 [m/s]
  std::vector<Vec3> external_;         // gravity and air [N]
  std::vector<Vec3> startOffsets_;     // between the springs' ends, at x0 [m]
  std::vector<double> startExcess_;    // L^2 - l0^2 at x0 [m^2]
  std::vector<Vec3> offsets_;          // at x0 + h v [m]
  std::vector<Vec3> springForces_;     // elastic and damping, on the first end [N]
  std::vector<double> springEnergy_;   // elastic and h C_d / 2 |v_i - v_j|^2 [J]
  std::vector<double> springSize_;     // sum of the sizes of the terms of its force, for rounding errors [N]
  std::vector<Vec3> gradient_;
  std::vector<double> size_;  // the same for a vertex's gradient [N s]
  std::vector<Mat3> diagonal_;
  std::vector<Mat3> pairBlocks_;    // of springs or pairs [kg]
  FabricEnergy fabric_;             // if the model has a fabric; the data of springs are then empty
  std::vector<Vec3> displacement_;  // since x0, of a fabric [m]
  std::optional<Attachment> attachment_;
  AttachedCorners attachedCorners_;            // of `attachment_`
  Vec3 attachmentStartOffset_ = Vec3::Zero();  // from the attached point to the target, at x0 [m]
  Vec3 attachmentOffset_ = Vec3::Zero();       // the same at x0 + h v [m]
};

}  // namespace drape::sim
