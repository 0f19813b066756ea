// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/verlet_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/air-inl.hpp"
#include "sim/simd/fabric-inl.hpp"
#include "sim/simd/lanes-inl.hpp"
#include "sim/simd/sliced_cloth.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// Stoermer-Verlet: drift by half a step, one evaluation of the forces there, kick, drift by the other half.
/// `hasFabric`: the elastic forces are those of a fabric, not of springs.
template <typename T, bool hasFabric>
class VerletKernel {
  using D = LanesOf<T>;
  using V3 = Lanes3<D>;

 public:
  VerletKernel(SlicedCloth<T>& cloth, const SliceStep<T>& step, T drift, const StepShare& share)
      : cloth_(cloth),
        layout_(cloth.layout),
        step_(step),
        share_(share),
        drift_(drift),
        terms_(cloth.terms[share.member].data()),
        air_(step.drag != T(0) || step.lift != T(0)) {}

  /// A slice is updated as soon as no other slice reads its old position and velocity.
  void firstPhase() {
    int settled = share_.innerBegin(1);
    for (int slice = share_.begin; slice < share_.end; ++slice) {
      for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(D()))) {
        kick(slice, lane);
      }
      while (step_.updatesVelocity && settled < share_.innerEnd(1) && layout_.lastNeighbourSlice[settled] <= slice) {
        settle(settled++);
      }
    }
  }

  /// The slices at the ends of the share, whose old values other threads read.
  void laterPhase() {
    if (!step_.updatesVelocity) {
      return;
    }
    for (int slice = share_.begin; slice < share_.innerBegin(1); ++slice) {
      settle(slice);
    }
    for (int slice = share_.innerEnd(1); slice < share_.end; ++slice) {
      settle(slice);
    }
  }

 private:
  HWY_INLINE void kick(int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    const V3 x = load3(d, cloth_.position, i);
    const V3 v = load3(d, cloth_.velocity, i);
    const auto mass = hn::LoadU(d, cloth_.mass.data() + i);
    const auto weight = hn::Mul(mass, hn::Set(d, step_.gravity));
    V3 force = {hn::Zero(d), hn::Neg(weight), hn::Zero(d)};
    auto energy = hn::Mul(weight, x.y);
    if constexpr (hasFabric) {
      addFabric(d, cloth_, step_, terms_, slice, lane, x, air_, force, energy);
    } else {
      addSprings(slice, lane, x, v, force, energy);
      if (air_) {
        force = addAir(d, cloth_, step_, terms_, slice, lane, force);
      }
    }
    auto unused = mass;
    addAttachment(d, step_, slice, lane, force, unused);
    const auto time = hn::Mul(hn::Set(d, step_.timeStep), hn::LoadU(d, cloth_.free.data() + i));
    V3 after = multiplyAdd(force, hn::Div(time, mass), v);
    if (step_.aggregates != nullptr) {
      after = multiplyAdd(aggregateAcceleration(d, *step_.aggregateAccelerations, step_.aggregates + i), time, after);
    }
    if (HWY_UNLIKELY(step_.energy != nullptr)) {
      hn::StoreU(hn::MulAdd(hn::Mul(hn::Set(d, T(0.5)), mass), dot(v, after), energy), d, step_.energy + i);
    }
    store3(d, after, cloth_.start, i);
  }

  /// Adds the forces of the springs of some lanes, and half of the springs' energy.
  HWY_INLINE void addSprings(int slice, int lane, const V3& x, const V3& v, V3& force, hn::Vec<D>& energy) {
    const D d;
    auto* terms = terms_;
    const auto* const uneven = cloth_.relativeStiffness.empty() ? nullptr : cloth_.relativeStiffness.data();
    const int end = layout_.slotBegin[slice + 1];
    for (int slot = layout_.slotBegin[slice]; slot < end; ++slot, ++terms) {
      const auto at = static_cast<std::size_t>(slot);
      const Neighbours<D> neighbours(layout_, layout_.slots[at], lane);
      const V3 offset = subtract(neighbours.load(cloth_.position), x);
      const auto rest = hn::LoadU(d, cloth_.restLength[at].data() + lane);
      const auto elongation = elongationOf(d, offset, rest);
      auto stiffness = hn::Set(d, step_.stiffness);
      if (HWY_UNLIKELY(uneven != nullptr)) {
        stiffness = hn::Mul(stiffness, hn::LoadU(d, uneven[at].data() + lane));
      }
      if (step_.stiffnessScales != nullptr) {
        stiffness = hn::Mul(stiffness, hn::LoadU(d, step_.stiffnessScales[at].data() + lane));
      }
      const auto elastic = elasticOf(d, elongation, stiffness);
      force = multiplyAdd(offset, elastic, force);
      if (HWY_UNLIKELY(step_.energy != nullptr)) {
        energy = hn::Add(energy, halfEnergyOf(d, elongation, offset, rest, stiffness, elastic));
      }
      if (step_.damping != T(0)) {
        const auto damping = hn::IfThenElseZero(elongation.present, hn::Set(d, step_.damping));
        force = multiplyAdd(subtract(neighbours.load(cloth_.velocity), v), damping, force);
      }
      if (air_) {
        storeOffset(d, *terms, lane, offset);
      }
    }
  }

  HWY_INLINE void settle(int slice) {
    const D d;
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
      const int i = slice * sliceLanes + lane;
      const V3 v = load3(d, cloth_.start, i);
      const V3 drifting = step_.driftsByOldVelocity ? load3(d, cloth_.velocity, i) : v;
      store3(d, v, cloth_.velocity, i);
      store3(d, multiplyAdd(drifting, hn::Set(d, drift_), load3(d, cloth_.position, i)), cloth_.position, i);
    }
  }

  SlicedCloth<T>& cloth_;
  const SliceLayout& layout_;
  const SliceStep<T>& step_;
  const StepShare& share_;
  T drift_;  // time of the drift after the kick [s]
  SpringTerms<T>* terms_;
  bool air_;
};

template <typename T, bool hasFabric>
void runPhase(SlicedCloth<T>& cloth, const SliceStep<T>& step, T drift, const StepShare& share, int phase) {
  VerletKernel<T, hasFabric> kernel(cloth, step, drift, share);
  phase == 0 ? kernel.firstPhase() : kernel.laterPhase();
}

void verletFloat(SlicedCloth<float>& cloth, const SliceStep<float>& step, float drift, const StepShare& share,
                 int phase) {
  cloth.fabric ? runPhase<float, true>(cloth, step, drift, share, phase)
               : runPhase<float, false>(cloth, step, drift, share, phase);
}

void verletDouble(SlicedCloth<double>& cloth, const SliceStep<double>& step, double drift, const StepShare& share,
                  int phase) {
  cloth.fabric ? runPhase<double, true>(cloth, step, drift, share, phase)
               : runPhase<double, false>(cloth, step, drift, share, phase);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(verletFloat);
HWY_EXPORT(verletDouble);

void verletPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, float drift, const StepShare& share,
                 int phase) {
  HWY_DYNAMIC_DISPATCH(verletFloat)(cloth, step, drift, share, phase);
}

void verletPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, double drift, const StepShare& share,
                 int phase) {
  HWY_DYNAMIC_DISPATCH(verletDouble)(cloth, step, drift, share, phase);
}

}  // namespace drape::sim::simd
#endif
