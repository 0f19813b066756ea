#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/simd/slice_layout.hpp"
#include "sim/simd/sliced_fabric.hpp"
#include "sim/simd/step_share.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace drape::sim::simd {

/// One number for each vertex of a cloth, by permuted index. There is room at both ends, so that a slot of consecutive
/// neighbours can be loaded whole.
template <typename T>
class LaneArray {
 public:
  void resize(int slices) { slices_.assign(static_cast<std::size_t>(slices) + 3, {}); }
  [[nodiscard]] bool sized() const { return !slices_.empty(); }
  /// The value of permuted index 0.
  [[nodiscard]] T* data() { return slices_[1].data(); }
  [[nodiscard]] const T* data() const { return slices_[1].data(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const { return slices_.capacity() * sizeof(SliceNumbers<T>); }

 private:
  std::vector<SliceNumbers<T>> slices_;
};

/// A vector for each vertex. On irregular meshes, where neighbours are fetched one by one, the vectors are also stored
/// with interleaved coordinates, so that one load fetches each.
template <typename T>
struct LaneVectors {
  LaneArray<T> x, y, z;
  std::vector<T> interleaved;  ///< x y z and an unused number for each permuted index; empty on a regular mesh

  void resize(int slices, bool irregular) {
    x.resize(slices);
    y.resize(slices);
    z.resize(slices);
    interleaved.assign(irregular ? static_cast<std::size_t>(slices) * sliceLanes * 4 : 0, T(0));
  }

  [[nodiscard]] bool sized() const { return x.sized(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const {
    return x.bytes() + y.bytes() + z.bytes() + interleaved.capacity() * sizeof(T);
  }

  void set(std::size_t index, T newX, T newY, T newZ) {
    x.data()[index] = newX;
    y.data()[index] = newY;
    z.data()[index] = newZ;
    if (!interleaved.empty()) {
      interleaved[4 * index] = newX;
      interleaved[4 * index + 1] = newY;
      interleaved[4 * index + 2] = newZ;
    }
  }
};

/// The parameters of a step, in the precision of the step.
template <typename T>
struct SliceStep {
  /// The attachment at a corner of its triangle. Slice -1: there is none.
  struct AttachedCorner {
    int slice = -1;
    int lane = 0;
    T forceX = 0;
    T forceY = 0;
    T forceZ = 0;     ///< [N]
    T stiffness = 0;  ///< [N/m]
  };

  T timeStep = 0;   ///< h [s]
  T stiffness = 0;  ///< k [N/m]
  T damping = 0;    ///< C_d [N s/m]
  T gravity = 0;    ///< [m/s^2]
  T drag = 0;       ///< 1/2 rho C_D [kg/m^3]
  T lift = 0;       ///< 1/2 rho C_L [kg/m^3]
  T edgeDrag = 0;   ///< 1/2 rho C of a plate along the wind [kg/m^3]
  AirModel airModel = AirModel::Auto;
  T windX = 0;       ///< [m/s]
  T windY = 0;       ///< [m/s]
  T windZ = 0;       ///< [m/s]
  T relaxation = 1;  ///< of the sweeps [-]
  ForceDerivative derivative = ForceDerivative::Stabilised;
  int sweeps = 1;
  /// Weights of Chebyshev's acceleration, one a sweep. The sweep before the last counts by 1 - weight. Null: none.
  const T* weights = nullptr;
  std::array<AttachedCorner, 3> attachedCorners = {};

  /// Verlet: the drift after the kick uses the velocity before the kick. That makes the step explicit Euler.
  bool driftsByOldVelocity = false;
  /// Verlet: the kick updates the velocities, and vertices drift. Otherwise the new velocities are left in `start` for
  /// the stages of strong damping (damping_stages.hpp).
  bool updatesVelocity = true;
  /// Slope of the lift at zero incidence [kg/m^3] (kernels::liftRise). The lift is then implicit, so that it never
  /// changes the side of a vertex that faces the air (addAir). 0: eq. 19 as printed, which jumps at zero incidence.
  T liftRise = T(0);
  /// Verlet with a fabric: the weights of air and bending in this kick [-]. In multiple time stepping each acts in one
  /// of several kicks, and its weight is the number of these kicks. 0: it does not act.
  T airWeight = T(1);
  T bendingWeight = T(1);
  /// Verlet: stiffness scale of each spring [-], one number a slot and lane. Null: all are 1.
  const SliceNumbers<T>* stiffnessScales = nullptr;
  /// Verlet: the aggregate of each permuted index, and additional accelerations of the aggregates [m/s^2]. Null: none.
  const std::int32_t* aggregates = nullptr;
  const LaneVectors<T>* aggregateAccelerations = nullptr;
  /// Verlet: receives each vertex's energy in the middle of the step, 1/2 m v.v' + m g y + half of its springs' energy
  /// [J]. Null if it is not needed.
  T* energy = nullptr;
};

/// Data of the springs in a slot, stored at their evaluation for the sweeps and the normals.
template <typename T>
struct SpringTerms {
  SliceNumbers<T> x, y, z;  ///< the offset to the neighbour [m]
  SliceNumbers<T> alpha;    ///< [N s/m]
  SliceNumbers<T> beta;     ///< [N s/m^3]

  /// Distance between the same number of two successive slots.
  static constexpr int stride = 5 * sliceLanes;
};

/// A symmetric matrix for each vertex of a slice: xx xy xz yy yz zz.
template <typename T>
using SliceMatrices = std::array<SliceNumbers<T>, 6>;

/// A cloth in the sliced layout, with the memory for a step: at most 200 bytes a vertex in float.
template <typename T>
struct SlicedCloth {
  explicit SlicedCloth(const ClothModel& model);

  void setMassesAndPins(const ClothModel& model);

  /// Before `load`: sets the origin of the positions.
  void chooseOrigin(const ClothState& state);

  /// Read a thread's share of positions and velocities from a state, and write it back.
  void load(const ClothState& state, const StepShare& share);
  void store(ClothState& state, const StepShare& share);

  SliceLayout layout;
  std::vector<SliceNumbers<T>> restLength;  ///< one a slot [m]; negative where a lane has no spring
  /// One a slot [-]; empty if all springs are equally stiff.
  std::vector<SliceNumbers<T>> relativeStiffness;
  std::optional<SlicedFabric<T>> fabric;  ///< replaces the springs' forces; nothing: springs
  LaneArray<T> mass;                      ///< [kg]; 1 in lanes beyond the last vertex
  LaneArray<T> area;                      ///< [m^2]
  LaneArray<T> free;                      ///< 1; 0 where pinned or beyond the last vertex
  std::vector<int> pinned;                ///< permuted indices of pinned vertices
  Vec3 origin = Vec3::Zero();             ///< of `position`, see stepOrigin [m]
  LaneVectors<T> position, velocity;      ///< [m], [m/s]
  LaneVectors<T> start;                   ///< p_i, the start of the sweeps [m/s]
  std::array<LaneVectors<T>, 2> change;   ///< dv_i of alternate sweeps [m/s]; only with several sweeps

  /// Data of each thread: evaluated springs that are still needed, inverse matrices, and the progress of each sweep.
  std::vector<std::vector<SpringTerms<T>>> terms;
  std::vector<std::vector<SliceMatrices<T>>> inverses;  ///< W_ii^-1 [1/kg] of as many slices
  std::vector<std::vector<int>> done;
  std::vector<std::vector<Vec3>> pinnedPositions;  // while a state is written [m]

  /// Allocates memory for a step with these numbers of threads and sweeps.
  void prepare(int threads, int sweeps);

  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// One phase of a step of the one-iteration method (eqs. 7-16, with damping, gravity, air and attachment) for the
/// slices of one thread, with the widest vector instructions of the machine. There are phases 0 to `sweeps`; with one
/// thread phase 0 does everything. The result is the same for any number of threads and for all instruction sets with
/// fused multiply-add.
void oneIterationPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, const StepShare& share, int phase);
void oneIterationPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, const StepShare& share, int phase);

/// Stoermer-Verlet (drift by half a step, kick, drift by half a step) in two phases for the slices of one thread. Phase
/// 0 does the kick and a drift by the time `drift`. Phase 1 finishes the slices that depend on other threads.
void verletPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, float drift, const StepShare& share,
                 int phase);
void verletPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, double drift, const StepShare& share,
                 int phase);

/// Parameters of the springs of a coarse level, which resist stretching only (sim/adaptive/coarse_motion.hpp).
template <typename T>
struct TensionStep {
  const SliceNumbers<T>* stiffness = nullptr;  ///< of each spring, one number a slot and lane [N/m]
  const std::int32_t* aggregates = nullptr;    ///< as in SliceStep, of the next coarser level; null: there is none
  const LaneVectors<T>* aggregateAccelerations = nullptr;
  T* energy = nullptr;  ///< receives half the energy of each vertex's springs [J]; null if it is not needed
};

/// Computes the accelerations of a coarse level by tension, plus those of the coarser level, into `start`.
void accelerateByTension(SlicedCloth<float>& level, const TensionStep<float>& step);
void accelerateByTension(SlicedCloth<double>& level, const TensionStep<double>& step);

/// x += time v for the slices of one thread.
template <typename T>
void driftSlices(SlicedCloth<T>& cloth, T time, const StepShare& share);

}  // namespace drape::sim::simd
