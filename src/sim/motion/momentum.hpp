#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"

#include <optional>
#include <vector>

namespace drape::sim {

/// The barycentre of the cloth [m].
[[nodiscard]] Vec3 barycentreOf(const ClothModel& model, const ClothState& state);

/// The sum of m v over all vertices [kg m/s].
[[nodiscard]] Vec3 linearMomentum(const ClothModel& model, const ClothState& state);

/// The sum of m (x - about) x v over all vertices [kg m^2/s].
[[nodiscard]] Vec3 angularMomentum(const ClothModel& model, const ClothState& state, const Vec3& about);

/// Restores the momentum of every free piece of a cloth after a step. Springs and damping act between two vertices and
/// cannot change the momentum of a piece, but a step that solves its system approximately does.
///
/// After a step the rigid motion c = a + omega x r is added to the velocities of a piece, and its displacement to the
/// positions, so that
/// - the linear momentum is that before the step plus h times gravity, air and attachment;
/// - the angular momentum about the moving barycentre is that before the step plus h times their torque.
/// Gravity and air count as at the start of the step. The attachment's force is implicit, as in the implicit methods;
/// otherwise a stiff attachment would be unstable with a light piece. A piece on a line has no inertia about that line
/// and keeps its rotation about it. Pieces with pins are not corrected, since the pins change their momentum.
class MomentumKeeper {
 public:
  /// Stores the momentum before a step.
  void prepare(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
               const ClothState& state);

  /// Corrects the state after the step that `prepare` began.
  /// @param driftTime time [s] for which the velocity at the end of the step acts on the positions: h for backward
  /// Euler
  void correct(const ClothModel& model, double timeStep, double driftTime, ClothState& state);

 private:
  using Pieces = std::vector<std::vector<std::size_t>>;

  /// The momentum of a piece at the end of the step, without the attachment.
  struct Target {
    Vec3 linear = Vec3::Zero();         // [kg m/s]
    Vec3 angular = Vec3::Zero();        // about the barycentre [kg m^2/s]
    bool attached = false;              // whether the attachment pulls at this piece
    Vec3 attachmentArm = Vec3::Zero();  // from the barycentre to the attached point [m]
  };

  static Target targetOf(const ClothModel& model, const CommonParameters& parameters,
                         const std::vector<std::size_t>& piece, const ClothState& state,
                         const std::optional<AttachmentForce>& pull, const Vec3& attachedPoint);
  void correctPiece(const ClothModel& model, double timeStep, double driftTime, const std::vector<std::size_t>& piece,
                    const Target& target, const Vec3& attachmentMotion, ClothState& state) const;

  ModelCache<Pieces> pieces_;
  std::vector<Target> targets_;
  std::optional<AttachmentForce> pull_;
  Vec3 attachedPoint_ = Vec3::Zero();  // the attached point before the step [m]
};

}  // namespace drape::sim
