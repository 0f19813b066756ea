#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/sparse_system.hpp"
#include "sim/step_parameters.hpp"
#include "sim/workers.hpp"

#include <optional>
#include <vector>

namespace drape {

/// The function of the end velocities v whose minimum is a step of backward Euler with nothing linearised,
///
///     Phi(v) = 1/2 (v - v0)^T M (v - v0) - h v.g + E(x0 + h v) + h C_d / 2 sum_ij |v_i - v_j|^2
///
/// where E is the energy of springs and hand, and g is gravity and air, which are evaluated at the start of the step.
/// Its gradient is what the step's equations leave over, M (v - v0) - h f(x0 + h v, v).
///
/// Springs are evaluated by how they change from x0, not from positions: how long a stiff spring is can be had from
/// positions near 1 m to 1e-16 m only, and that alone would leave more over than a solve is asked to.
class IncrementalPotential {
 public:
  /// What is found at some velocities. Pinned vertices count nowhere.
  struct Value {
    double value = 0.0;          ///< Phi [J]
    double valueRounding = 0.0;  ///< how much of that rounding may have made up [J]
    double residual = 0.0;       ///< norm of the gradient [N s]
    double rounding = 0.0;       ///< norm of what rounding leaves over of it at best [N s]
  };

  /// Takes a step's start. What it refers to must outlive the step.
  void begin(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
             const ClothState& state, Workers& workers);

  /// Evaluates value and gradient. `velocities` are zero where pinned.
  Value evaluate(const std::vector<Vec3>& velocities);

  /// The gradient where it was last evaluated [N s], one a vertex, zero where pinned.
  [[nodiscard]] const std::vector<Vec3>& gradient() const { return gradient_; }

  /// Fills in the second derivative where the gradient was last evaluated [kg], with the springs' derivative in the
  /// given variant.
  void fillHessian(ForceDerivative variant, SparseSystem& hessian);

 private:
  void beginSpring(std::size_t spring, const ClothState& state);
  void evaluateSpring(std::size_t spring, const std::vector<Vec3>& velocities);
  void gatherVertex(std::size_t vertex, const std::vector<Vec3>& velocities);
  double addAttachment(const std::vector<Vec3>& velocities);
  [[nodiscard]] Value sum(const std::vector<Vec3>& velocities, double attachmentEnergy) const;

  const ClothModel* model_ = nullptr;
  const StepParameters* parameters_ = nullptr;
  Workers* workers_ = nullptr;
  std::vector<Vec3> startVelocities_;  // v0 [m/s]
  std::vector<Vec3> external_;         // gravity and air [N]
  std::vector<Vec3> startOffsets_;     // of the springs' ends at x0 [m]
  std::vector<double> startExcess_;    // L^2 - l0^2 at x0 [m^2]
  std::vector<Vec3> offsets_;          // at x0 + h v [m]
  std::vector<Vec3> springForces_;     // elastic and damping, on the first end [N]
  std::vector<double> springEnergy_;   // elastic and h C_d / 2 |v_i - v_j|^2 [J]
  std::vector<double> springSize_;     // of the numbers that its force is made of [N]
  std::vector<Vec3> gradient_;
  std::vector<double> size_;  // of the numbers that a vertex' gradient is made of [N s]
  std::vector<Mat3> diagonal_;
  std::vector<Mat3> springBlocks_;
  std::optional<Attachment> attachment_;
  Vec3 attachmentStartOffset_ = Vec3::Zero();  // from the held point to the hand, at x0 [m]
  Vec3 attachmentOffset_ = Vec3::Zero();       // and at x0 + h v [m]
};

}  // namespace drape
