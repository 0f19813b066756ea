#pragma once

#include "sim/fabric/bending_damping.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/simd/damping_stages.hpp"
#include "sim/simd/sliced_cloth_cache.hpp"
#include "sim/simd/thread_team.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace drape::sim::simd {

/// The velocity of a pinned vertex that a body carries [m/s].
struct PinVelocity {
  std::size_t vertex = 0;
  Vec3 velocity = Vec3::Zero();
};

/// The damping of a fabric (fabric::Material::stretchDamping and bendDamping), split from the step of a solver.
///
/// It integrates dv/dt = -M^-1 Z v over a time step with constant positions, first for stretch and shear, then for
/// bending. Z of stretch is the damping time times the membrane's stiffness without its geometric part and without
/// stiffening; Z of bending is the damping time times that of fabric::BendingDamping. Both vanish for rigid motion. The
/// stages of damping_stages.hpp are stable for every damping time. Where more than `maxStages` of them were needed, the
/// damping time is reduced to what they allow.
///
/// Together with the step of a solver that is a splitting of first order in the velocities. For cloth that starts at
/// rest the positions are of second order, as with a symmetric splitting.
class FabricDamper {
 public:
  static constexpr int maxStages = 128;

  /// Damps the velocities of `state` over parameters.timeStep. The result does not depend on the number of threads.
  /// @param model must have a fabric  @param pins the pinned vertices that move
  /// @return the change of the kinetic energy [J]; up to rounding not positive, with pins that move at most the kinetic
  /// energy of the whole cloth at the speed of the fastest pin
  double damp(const ClothModel& model, const CommonParameters& parameters, std::span<const PinVelocity> pins,
              ClothState& state);

 private:
  /// The data that depend on the model only.
  struct Constants {
    double membraneRate = 0.0;  // the highest rate of M^-1 Z of stretch for a damping time of one second [1/s^2]
    std::optional<fabric::BendingDamping> bending;
  };
  /// A cloth in one precision.
  template <typename T>
  struct Sliced {
    SlicedClothCache<T> cloths;
    ModelCache<SlicedBendingDamping<T>> bending;
  };

  [[nodiscard]] static Constants constantsOf(const ClothModel& model);
  template <typename T>
  [[nodiscard]] std::vector<DampingRun<T>> runsOf(const ClothModel& model, const Constants& constants, double timeStep,
                                                  Sliced<T>& sliced);
  template <typename T>
  void run(const ClothModel& model, const CommonParameters& parameters, int refinement,
           std::span<const PinVelocity> pins, Sliced<T>& sliced, ClothState& state);

  ThreadTeam team_;
  Sliced<float> single_;
  Sliced<double> double_;
  ModelCache<Constants> constants_;
  std::vector<Vec3> before_;  // velocities [m/s]
};

}  // namespace drape::sim::simd
