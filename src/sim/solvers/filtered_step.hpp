#pragma once

#include "sim/constant_filter.hpp"
#include "sim/model_cache.hpp"
#include "sim/solver.hpp"
#include "sim/workers.hpp"

#include <vector>

namespace drape {

/// Where the rotation is taken back that filtering the forces brought in.
enum class RotationCorrection { Positions, Velocities };

/// The step that the solvers `desbrun` and `meyer` share:
///
///     F_i  = springs + damping + h sum_j k (v_j - v_i)       at the start of the step
///     Ff   = M A^-1 F,  A = M + (h^2 k + h C_d) L            the constant filter (constant_filter.hpp)
///     v_i += h (Ff_i + Fext_i) / m_i,  x_i += h v_i
///
/// Gravity and air are external: they are not filtered. So a hanging cloth comes to rest where its springs bear
/// A M^-1 times its weight: a spring next to a pin is longer by h^2 g (and h C_d g / k) than it should be.
///
/// The filter acts on the forces as if springs without rest length had exerted them, and the result has a torque.
/// Pieces without pins get it back: with T = sum_i r_i x Ff_i about the barycentre and I the tensor of inertia, both at
/// the start of the step, the rigid velocity change c_i = -h (I^-1 T) x r_i has the angular impulse -h T. In print
/// (1999) the correction is a force (x_G - x_i) x (h T') with T' = sum_i Ff_i x x_i = -T, and moves x_i by that times
/// h^2 / m: the same axis and sense, but it is no length; its size depends on the units, and the inverse inertia is
/// what it lacks. Cloth with pins rightly feels a torque from them and is not corrected.
///
/// The hand is ours. A pull at one point that is not filtered would throw light vertices about, so it is: it stands in
/// F, and its stiffness, lumped on the corners that it holds, on the diagonal of A. Its torque is no fault and stays.
class FilteredStepSolver final : public Solver {
 public:
  explicit FilteredStepSolver(RotationCorrection correction) : correction_(correction) {}

  StepReport step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                  ClothState& state) override;

 private:
  /// h F, the internal impulse of a vertex [N s].
  static Vec3 internalImpulse(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                              std::size_t vertex);
  void addAttachment(const ClothModel& model, double timeStep, const Attachment& attachment, const ClothState& state);
  void findCorrection(const ClothModel& model, const ClothState& state);
  void move(const ClothModel& model, const StepParameters& parameters, ClothState& state);

  RotationCorrection correction_;
  Workers workers_;
  ConstantFilter filter_;
  ModelCache<std::vector<std::vector<std::size_t>>> pieces_;
  std::vector<Vec3> filtered_;               // h M^-1 Ff, what the internal forces change the velocities by [m/s]
  std::vector<Vec3> external_;               // h M^-1 Fext [m/s]
  std::vector<Vec3> rotation_;               // c [m/s]; zero in pieces with pins
  AttachmentDiagonal attachment_;            // while there is one
  std::array<Vec3, 3> attachmentImpulse_{};  // on its corners: h times its force, before its stiffness [N s]
  bool held_ = false;
};

}  // namespace drape
