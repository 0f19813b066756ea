#pragma once

#include "sim/cloth_state.hpp"
#include "sim/simd/slice_layout.hpp"
#include "sim/simd/step_share.hpp"
#include "sim/step_parameters.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace drape {

/// Numbers for the lanes of a slice, aligned to a cache line so that no load straddles two.
template <typename T>
struct alignas(64) SliceNumbers : std::array<T, sliceLanes> {};

/// Numbers of a cloth's vertices in the order of a step, one array a coordinate, with room at both ends so that a slot
/// of consecutive neighbours can be loaded whole.
template <typename T>
class LaneArray {
 public:
  void resize(int slices) { slices_.assign(static_cast<std::size_t>(slices) + 3, {}); }
  [[nodiscard]] bool sized() const { return !slices_.empty(); }
  /// The value of place 0.
  [[nodiscard]] T* data() { return slices_[1].data(); }
  [[nodiscard]] const T* data() const { return slices_[1].data(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const { return slices_.capacity() * sizeof(SliceNumbers<T>); }

 private:
  std::vector<SliceNumbers<T>> slices_;
};

/// A vector in space for each vertex. On an irregular mesh, where neighbours have to be fetched one by one, the vectors
/// are kept a second time with their coordinates side by side, so that each is fetched by one load.
template <typename T>
struct LaneVectors {
  LaneArray<T> x, y, z;
  std::vector<T> sideBySide;  ///< x y z and a number that is never read, for each place; empty on a regular mesh

  void resize(int slices, bool irregular) {
    x.resize(slices);
    y.resize(slices);
    z.resize(slices);
    sideBySide.assign(irregular ? static_cast<std::size_t>(slices) * sliceLanes * 4 : 0, T(0));
  }

  [[nodiscard]] bool sized() const { return x.sized(); }
  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const {
    return x.bytes() + y.bytes() + z.bytes() + sideBySide.capacity() * sizeof(T);
  }

  void set(std::size_t place, T newX, T newY, T newZ) {
    x.data()[place] = newX;
    y.data()[place] = newY;
    z.data()[place] = newZ;
    if (!sideBySide.empty()) {
      sideBySide[4 * place] = newX;
      sideBySide[4 * place + 1] = newY;
      sideBySide[4 * place + 2] = newZ;
    }
  }
};

/// What a step does beside its springs, in the precision of the step.
template <typename T>
struct SliceStep {
  /// The hand at a corner of its triangle. Slice -1: there is none.
  struct AttachedCorner {
    int slice = -1;
    int lane = 0;
    T forceX = 0;
    T forceY = 0;
    T forceZ = 0;     ///< [N]
    T stiffness = 0;  ///< [N/m]
  };

  T timeStep = 0;    ///< h [s]
  T stiffness = 0;   ///< k [N/m]
  T damping = 0;     ///< C_d [N s/m]
  T gravity = 0;     ///< [m/s^2]
  T drag = 0;        ///< 1/2 rho C_D [kg/m^3]
  T lift = 0;        ///< 1/2 rho C_L [kg/m^3]
  T windX = 0;       ///< [m/s]
  T windY = 0;       ///< [m/s]
  T windZ = 0;       ///< [m/s]
  T relaxation = 1;  ///< of the sweeps [-]
  ForceDerivative derivative = ForceDerivative::Stabilised;
  int sweeps = 1;
  /// Of Chebyshev's acceleration, one a sweep: the answer counts by so much, 1 - weight the sweep before the last.
  /// Null: none.
  const T* weights = nullptr;
  std::array<AttachedCorner, 3> attachedCorners = {};

  /// Of Verlet: the drift after the kick is by the velocity from before it, which makes the step explicit Euler's.
  bool driftsByOldVelocity = false;
  /// Of Verlet: the velocity after the kick takes the place of the one before, and vertices drift on. Else it is left
  /// in `start`, for strong damping to be dealt with (damping_stages.hpp).
  bool settles = true;
  /// How lift rises with the incidence [kg/m^3] (kernels::liftRise), taken implicitly, so that it never turns the side
  /// that a vertex faces the air with (addAir). 0: eq. 19 as printed, which jumps where the cloth lies along the wind.
  T liftRise = T(0);
  /// Of Verlet: the share of its stiffness that each spring keeps, one number a slot and lane. Null: all of it.
  const SliceNumbers<T>* shares = nullptr;
  /// Of Verlet: the group that each place belongs to, and the acceleration [m/s^2] of each group that comes on top of
  /// what the springs give. Null: none.
  const std::int32_t* groups = nullptr;
  const LaneVectors<T>* pushes = nullptr;
  /// Of Verlet: takes each place's energy in the middle of the step, 1/2 m v.v' + m g y + half of its springs' [J].
  /// Null: nobody asks.
  T* energy = nullptr;
};

/// What the sweeps and the normals need of the springs in a slot, kept from when they were evaluated.
template <typename T>
struct SpringTerms {
  SliceNumbers<T> x, y, z;  ///< the offset to the neighbour [m]
  SliceNumbers<T> alpha;    ///< [N s/m]
  SliceNumbers<T> beta;     ///< [N s/m^3]

  /// From a number of one slot to the same number of the next.
  static constexpr int stride = 5 * sliceLanes;
};

/// A symmetric matrix for each vertex of a slice: xx xy xz yy yz zz.
template <typename T>
using SliceMatrices = std::array<SliceNumbers<T>, 6>;

/// A cloth laid out for vector instructions, with the memory that a step needs: at most 200 bytes a vertex in float.
template <typename T>
struct SlicedCloth {
  explicit SlicedCloth(const ClothModel& model);

  void setMassesAndPins(const ClothModel& model);

  /// Takes a thread's share of the positions and velocities over from a state, and gives them back.
  void load(const ClothState& state, const StepShare& share);
  void store(ClothState& state, const StepShare& share);

  SliceLayout layout;
  std::vector<SliceNumbers<T>> restLength;  ///< one a slot [m]; negative where a lane has no spring
  /// One a slot [-]; empty when all springs are equally stiff.
  std::vector<SliceNumbers<T>> relativeStiffness;
  LaneArray<T> mass;                     ///< [kg]; 1 in lanes beyond the last vertex
  LaneArray<T> area;                     ///< [m^2]
  LaneArray<T> free;                     ///< 1; 0 where pinned or beyond the last vertex
  std::vector<int> pinned;               ///< places of what is held
  LaneVectors<T> position, velocity;     ///< [m], [m/s]
  LaneVectors<T> start;                  ///< p_i, the start of the sweeps [m/s]
  std::array<LaneVectors<T>, 2> change;  ///< dv_i of alternate sweeps [m/s]; only with several

  /// What a thread needs for itself: springs that have been evaluated and are still needed, and how far each sweep is.
  std::vector<std::vector<SpringTerms<T>>> terms;
  std::vector<std::vector<SliceMatrices<T>>> inverses;  ///< W_ii^-1 [1/kg] of as many slices
  std::vector<std::vector<int>> done;
  std::vector<std::vector<Vec3>> heldPlaces;  // where pinned vertices are, while a state is written

  /// Makes room for a step of so many threads and sweeps.
  void prepare(int threads, int sweeps);

  /// The memory that it takes [bytes].
  [[nodiscard]] std::size_t bytes() const;
};

/// One phase of a step of the one-iteration method, eqs. 7-16 with damping, gravity, air and hand, for the slices of
/// one thread, by the widest vector instructions that the machine has. Phases 0 to `sweeps`; with one thread phase 0 is
/// all. The result is the same for any number of threads and for all instruction sets that have fused multiply-add.
void oneIterationPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, const StepShare& share, int phase);
void oneIterationPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, const StepShare& share, int phase);

/// Stoermer-Verlet, drift by half a step, kick, drift by the other half, in two phases for the slices of one thread.
/// Phase 0 kicks and drifts on by `drift`, phase 1 does so where phase 0 had to wait for other threads.
void verletPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, float drift, const StepShare& share,
                 int phase);
void verletPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, double drift, const StepShare& share,
                 int phase);

/// The springs of a coarse level of a cloth, which resist stretching only (sim/adaptive/coarse_motion.hpp).
template <typename T>
struct TensionStep {
  const SliceNumbers<T>* stiffness = nullptr;  ///< of each spring, one number a slot and lane [N/m]
  const std::int32_t* groups = nullptr;        ///< as in SliceStep, of the level above; null: there is none
  const LaneVectors<T>* pushes = nullptr;
  T* energy = nullptr;  ///< takes half the energy of each place's springs [J]; null: nobody asks
};

/// The accelerations that tension gives the places of a coarse level, and what the levels above add, into `start`.
void accelerateByTension(SlicedCloth<float>& level, const TensionStep<float>& step);
void accelerateByTension(SlicedCloth<double>& level, const TensionStep<double>& step);

/// x += time v for the slices of one thread.
template <typename T>
void driftSlices(SlicedCloth<T>& cloth, T time, const StepShare& share);

}  // namespace drape
