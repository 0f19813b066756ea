#pragma once

#include "sim/model/model_cache.hpp"
#include "sim/model/workers.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/systems/constant_filter.hpp"

#include <vector>

namespace drape::sim {

/// The quantities from which the rotation by filtered forces is removed.
enum class RotationCorrection { Positions, Velocities };

/// The step that the solvers `desbrun` and `meyer` share:
///
///     F_i  = springs + damping + h sum_j k (v_j - v_i)       at the start of the step
///     Ff   = M A^-1 F,  A = M + (h^2 k + h C_d) L            the constant filter (constant_filter.hpp)
///     v_i += h (Ff_i + Fext_i) / m_i,  x_i += h v_i
///
/// Gravity and air are external and not filtered. So a hanging cloth comes to rest where its springs carry A M^-1 times
/// its weight: a spring at a pin is too long by h^2 g (and h C_d g / k).
///
/// The filter treats the forces like those of springs without rest length, and the result has a torque. Pieces without
/// pins are corrected. With T = sum_i r_i x Ff_i about the barycentre and I the tensor of inertia, both at the start of
/// the step, the rigid velocity change c_i = -h (I^-1 T) x r_i has the angular impulse -h T. The paper of 1999 has the
/// force (x_G - x_i) x (h T') with T' = sum_i Ff_i x x_i = -T, and moves x_i by that times h^2 / m. This has the same
/// axis and sense, but not the unit of a length: the inverse inertia is missing. Pins exert a torque on cloth, so
/// pieces with pins are not corrected.
///
/// The attachment is not in the papers. An unfiltered force at one point would be unstable with light vertices, so it
/// is filtered: it is part of F, and its stiffness, lumped on the corners of its triangle, is on the diagonal of A. Its
/// torque is physical and not removed.
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
  std::vector<Vec3> filtered_;               // h M^-1 Ff, velocity change by internal forces [m/s]
  std::vector<Vec3> external_;               // h M^-1 Fext [m/s]
  std::vector<Vec3> rotation_;               // c [m/s]; zero in pieces with pins
  AttachmentDiagonal attachment_;            // if there is an attachment
  std::array<Vec3, 3> attachmentImpulse_{};  // on its corners: h times its force, without the implicit part [N s]
  bool attached_ = false;
};

}  // namespace drape::sim
