// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/damping_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/damping_stages.hpp"
#include "sim/simd/fabric_damping-inl.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

template <typename T, DampedPart dampedPart>
class DampingKernel {
  using D = LanesOf<T>;
  using V3 = Lanes3<D>;

 public:
  DampingKernel(SlicedCloth<T>& cloth, const DampingRun<T>& run, int stage)
      : cloth_(cloth),
        layout_(cloth.layout),
        gain_(run.gain),
        bending_(run.bending),
        dampingScales_(run.dampingScales),
        from_(stage % 2 == 1 ? cloth.velocity : cloth.start),
        to_(stage % 2 == 1 ? cloth.start : cloth.velocity),
        first_(stage == 1),
        // mu_j - 1 = -nu_j = (j - 1) / j, and mu~_j = mu_j 2 / (s^2 + s)
        back_(T(stage - 1) / T(stage)),
        part_(T(2 * stage - 1) / T(stage) * T(2) / (T(run.stages) * T(run.stages + 1))),
        damping_(part_ * run.timedDamping) {}

  void findBendingRates(const StepShare& share) {
    const D d;
    for (int slice = share.begin; slice < share.end; ++slice) {
      for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
        storeBendingRates(d, layout_, from_, slice, lane, *bending_);
      }
    }
  }

  void run(const StepShare& share) {
    for (int slice = share.begin; slice < share.end; ++slice) {
      for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(D()))) {
        damp(slice, lane);
      }
    }
  }

 private:
  /// v_j = v_{j-1} + (mu_j - 1) (v_{j-1} - v_{j-2}) + mu~_j (h a - h D v_{j-1}). Equal velocities stay equal.
  HWY_INLINE void damp(int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    const V3 v = load3(d, from_, i);
    const V3 sum = dampingOf(slice, lane, v);
    const auto inverseMass = hn::Div(hn::LoadU(d, cloth_.free.data() + i), hn::LoadU(d, cloth_.mass.data() + i));
    const V3 before = load3(d, to_, i);
    V3 after = first_ ? v : multiplyAdd(subtract(v, before), hn::Set(d, back_), v);
    if (gain_ != nullptr) {
      const V3 gain = first_ ? subtract(before, v) : load3(d, *gain_, i);
      if (first_) {
        store3(d, gain, *gain_, i);
      }
      after = multiplyAdd(gain, hn::Set(d, part_), after);
    }
    store3(d, multiplyAdd(sum, hn::Mul(hn::Set(d, damping_), inverseMass), after), to_, i);
  }

  /// The force against the velocities, per rate of the damping.
  HWY_INLINE V3 dampingOf(int slice, int lane, const V3& v) {
    const D d;
    if constexpr (dampedPart == DampedPart::Membrane) {
      return membraneDamping(d, cloth_, from_, slice, lane);
    } else if constexpr (dampedPart == DampedPart::Bending) {
      return bendingDamping(d, layout_, *bending_, slice, lane);
    } else {
      return springDamping(slice, lane, v);
    }
  }

  HWY_INLINE V3 springDamping(int slice, int lane, const V3& v) {
    const D d;
    V3 sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    const int end = layout_.slotBegin[slice + 1];
    for (int slot = layout_.slotBegin[slice]; slot < end; ++slot) {
      const auto at = static_cast<std::size_t>(slot);
      const Neighbours<D> neighbours(layout_, layout_.slots[at], lane);
      const V3 difference = subtract(neighbours.load(from_), v);
      if (dampingScales_ != nullptr) {
        sum = multiplyAdd(difference, hn::LoadU(d, dampingScales_[at].data() + lane), sum);
        continue;
      }
      const auto present = hn::Ge(hn::LoadU(d, cloth_.restLength[at].data() + lane), hn::Zero(d));
      sum = {hn::Add(sum.x, hn::IfThenElseZero(present, difference.x)),
             hn::Add(sum.y, hn::IfThenElseZero(present, difference.y)),
             hn::Add(sum.z, hn::IfThenElseZero(present, difference.z))};
    }
    return sum;
  }

  SlicedCloth<T>& cloth_;
  const SliceLayout& layout_;
  LaneVectors<T>* gain_;
  SlicedBendingDamping<T>* bending_;
  const SliceNumbers<T>* dampingScales_;
  const LaneVectors<T>& from_;
  LaneVectors<T>& to_;
  bool first_;
  T back_;     // mu_j - 1 [-]
  T part_;     // mu~_j [-]
  T damping_;  // mu~_j h C_d [N s^2/m]
};

template <typename T>
void dampPart(SlicedCloth<T>& cloth, const DampingRun<T>& run, int stage, const StepShare& share) {
  switch (run.part) {
    case DampedPart::Springs:
      return DampingKernel<T, DampedPart::Springs>(cloth, run, stage).run(share);
    case DampedPart::Membrane:
      return DampingKernel<T, DampedPart::Membrane>(cloth, run, stage).run(share);
    case DampedPart::Bending:
      return DampingKernel<T, DampedPart::Bending>(cloth, run, stage).run(share);
  }
}

void dampFloat(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share) {
  dampPart(cloth, run, stage, share);
}

void dampDouble(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share) {
  dampPart(cloth, run, stage, share);
}

void ratesFloat(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share) {
  DampingKernel<float, DampedPart::Bending>(cloth, run, stage).findBendingRates(share);
}

void ratesDouble(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share) {
  DampingKernel<double, DampedPart::Bending>(cloth, run, stage).findBendingRates(share);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(dampFloat);
HWY_EXPORT(dampDouble);
HWY_EXPORT(ratesFloat);
HWY_EXPORT(ratesDouble);

void dampingStage(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share) {
  HWY_DYNAMIC_DISPATCH(dampFloat)(cloth, run, stage, share);
}

void dampingStage(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share) {
  HWY_DYNAMIC_DISPATCH(dampDouble)(cloth, run, stage, share);
}

void bendingRates(SlicedCloth<float>& cloth, const DampingRun<float>& run, int stage, const StepShare& share) {
  HWY_DYNAMIC_DISPATCH(ratesFloat)(cloth, run, stage, share);
}

void bendingRates(SlicedCloth<double>& cloth, const DampingRun<double>& run, int stage, const StepShare& share) {
  HWY_DYNAMIC_DISPATCH(ratesDouble)(cloth, run, stage, share);
}

int dampingStages(double timesRate) {
  // s^2 + s >= h lambda, and even.
  const double minStages = std::ceil(0.5 * (std::sqrt(1.0 + 4.0 * timesRate) - 1.0));
  return 2 * static_cast<int>(std::ceil(0.5 * std::max(2.0, minStages)));
}

}  // namespace drape::sim::simd
#endif
