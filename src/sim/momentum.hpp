#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/external_forces.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"

#include <optional>
#include <vector>

namespace drape {

/// The sum of m v over all vertices [kg m/s].
[[nodiscard]] Vec3 linearMomentum(const ClothModel& model, const ClothState& state);

/// The sum of m (x - about) x v over all vertices [kg m^2/s].
[[nodiscard]] Vec3 angularMomentum(const ClothModel& model, const ClothState& state, const Vec3& about);

/// Gives every piece of a cloth that no pin holds the momentum back that a step took from it: springs and damping act
/// between two vertices and so cannot change it, but a step that solves its system approximately does.
///
/// After a step the velocities of a piece get the rigid motion c = a + omega x r, and its positions the way that c
/// covers, so that
/// - its linear momentum is the one before, plus h times gravity, air and hand;
/// - its angular momentum about its barycentre, which moves, is the one before, plus h times their torque.
/// Gravity and air count as they were at the start of the step; the hand is followed to the end of it, as the implicit
/// methods do, since otherwise a stiff hand would throw a light piece about. A piece on a line has no inertia about
/// that line and keeps the spin that it has there. Pieces with pins are left alone: what holds them takes momentum
/// rightly.
class MomentumKeeper {
 public:
  /// Looks at the cloth before a step.
  void before(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
              const ClothState& state);

  /// Corrects the state after the step that began with `before`.
  /// @param reach the time [s] for which the velocity at the step's end acts on the positions: h for backward Euler
  void after(const ClothModel& model, double timeStep, double reach, ClothState& state);

 private:
  using Pieces = std::vector<std::vector<std::size_t>>;

  /// What a piece should have at the end of the step, the hand left out.
  struct Target {
    Vec3 linear = Vec3::Zero();         // [kg m/s]
    Vec3 angular = Vec3::Zero();        // about the barycentre [kg m^2/s]
    bool held = false;                  // by the hand
    Vec3 attachmentArm = Vec3::Zero();  // from the barycentre to the held point [m]
  };

  static Target targetOf(const ClothModel& model, const StepParameters& parameters,
                         const std::vector<std::size_t>& piece, const ClothState& state,
                         const std::optional<AttachmentForce>& pull, const Vec3& attachedPoint);
  void correct(const ClothModel& model, double timeStep, double reach, const std::vector<std::size_t>& piece,
               const Target& target, const Vec3& attachmentMotion, ClothState& state) const;

  ModelCache<Pieces> pieces_;
  std::vector<Target> targets_;
  std::optional<AttachmentForce> pull_;
  Vec3 attachedPoint_ = Vec3::Zero();  // where the held point was [m]
};

}  // namespace drape
