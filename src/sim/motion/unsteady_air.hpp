#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/motion/rigid_motion.hpp"

#include <vector>

namespace drape::sim {

/// The mass of the air that a flat plate accelerates along its normal, over that of a strip of infinite span
/// (pi/4 rho c per area of the plate, with the chord c) [-]. It interpolates the figures of potential flow for
/// rectangles, 0.579 for a square and 0.757 for sides of 1 : 2 (Brennen 1982, A review of added mass and fluid inertial
/// forces).
/// @param shorter side [m]  @param longer side [m]
[[nodiscard]] double addedMassFactor(double shorter, double longer);

/// The air's forces on pieces that fall freely and are flat, beyond those that follow from the velocity and the normal
/// of each vertex (kernels::plateForce). They make a light sheet flutter and a heavy one tumble. They depend on the
/// motion of the whole piece, and act on its rigid motion only. The sources are Andersen, Pesavento and Wang 2005
/// (Unsteady aerodynamics of fluttering and tumbling plates):
/// - added mass along the normal and added inertia about both axes in the plate; the momentum of this air turns a plate
///   across its motion;
/// - rotational lift 1/2 C_R rho S c (omega x v), C_R = 1;
/// - a smaller resistance to rotation: that of kernels::plateForce at every vertex is about three times the measured
///   one.
/// A step conserves the sum of the momentum of the piece and that of the air which it moves. Rotational lift follows
/// the trapezoidal rule, so that it does no work.
///
/// Cloth that is not flat does not have these forces: they fade as the mean of the normals gets shorter than 0.9, and
/// end at 0.7.
class UnsteadyAir {
 public:
  /// Stores the motion at the start of a step. @param parameters its length, and the air
  void begin(const ClothModel& model, const CommonParameters& parameters, const ClothState& state);

  /// Whether a piece has these forces in this step.
  [[nodiscard]] bool acts() const { return !shares_.empty(); }
  /// Ends the forces of this step before they act.
  void stop() { shares_.clear(); }
  /// The longest step that resolves the motion of the pieces [s]: they move by a fourth of their shorter side, and meet
  /// 0.4 of their mass of air. Infinite if no piece has these forces.
  [[nodiscard]] double longestStep() const;

  /// Changes the velocities at the end of the step that `begin` began, and the positions by half of that times the
  /// step, as if the velocities had changed evenly over the step.
  /// @return the change of the kinetic energy [J]
  double apply(const ClothModel& model, ClothState& state) const;

 private:
  /// A free piece with its triangles, by index.
  struct Piece {
    std::vector<std::size_t> vertices;
    std::vector<std::size_t> triangles;
    double area = 0.0;  // at rest [m^2]
  };

  /// A piece with these forces, at the start of a step.
  struct Share {
    const Piece* piece = nullptr;
    double flatness = 0.0;        // 1 for a flat piece, 0 for one without these forces [-]
    double longestStep = 0.0;     // [s]
    double time = 0.0;            // for which the forces act [s]
    Vec3 linear = Vec3::Zero();   // momentum of the air, and the impulse of its forces [kg m/s]
    Vec3 angular = Vec3::Zero();  // the same about the barycentre [kg m^2/s]
    Vec3 turning = Vec3::Zero();  // the rotational lift is turning x velocity [kg/s]
  };

  [[nodiscard]] static std::vector<Piece> piecesOf(const ClothModel& model);
  [[nodiscard]] static double flatnessOf(const ClothModel& model, const Piece& piece, const ClothState& state);
  [[nodiscard]] static Share shareOf(const ClothModel& model, const CommonParameters& parameters, const Piece& piece,
                                     double flatness, const ClothState& state);
  /// The rigid motion with these forces at the end of a step. @param motion without them
  [[nodiscard]] RigidMotion changedBy(const Share& share, const RigidMotion& motion) const;

  ModelCache<std::vector<Piece>> pieces_;
  std::vector<Share> shares_;
  double timeStep_ = 0.0;     // [s]
  double density_ = 0.0;      // of the air [kg/m^3]
  Vec3 wind_ = Vec3::Zero();  // [m/s]
};

}  // namespace drape::sim
