// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/tension_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/lanes-inl.hpp"
#include "sim/simd/sliced_cloth.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

template <typename T>
HWY_INLINE void accelerateLanes(SlicedCloth<T>& level, const TensionStep<T>& step, int slice, int lane) {
  const LanesOf<T> d;
  const int i = slice * sliceLanes + lane;
  const auto x = load3(d, level.position, i);
  Lanes3<LanesOf<T>> force = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  auto energy = hn::Zero(d);
  const int end = level.layout.slotBegin[slice + 1];
  for (int slot = level.layout.slotBegin[slice]; slot < end; ++slot) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<LanesOf<T>> neighbours(level.layout, level.layout.slots[at], lane);
    const auto offset = subtract(neighbours.load(level.position), x);
    const auto rest = hn::LoadU(d, level.restLength[at].data() + lane);
    auto elongation = elongationOf(d, offset, rest);
    // Compressed springs exert no force.
    elongation.present = hn::And(elongation.present, hn::Lt(elongation.ratio, hn::Set(d, T(1))));
    elongation.directed = hn::And(elongation.directed, elongation.present);
    const auto stiffness = hn::LoadU(d, step.stiffness[at].data() + lane);
    const auto elastic = elasticOf(d, elongation, stiffness);
    force = multiplyAdd(offset, elastic, force);
    if (HWY_UNLIKELY(step.energy != nullptr)) {
      energy = hn::Add(energy, halfEnergyOf(d, elongation, offset, rest, stiffness, elastic));
    }
  }
  const auto free = hn::LoadU(d, level.free.data() + i);
  auto acceleration = scaled(force, hn::Div(free, hn::LoadU(d, level.mass.data() + i)));
  if (step.aggregates != nullptr) {
    acceleration =
        multiplyAdd(aggregateAcceleration(d, *step.aggregateAccelerations, step.aggregates + i), free, acceleration);
  }
  if (HWY_UNLIKELY(step.energy != nullptr)) {
    hn::StoreU(energy, d, step.energy + i);
  }
  store3(d, acceleration, level.start, i);
}

template <typename T>
void accelerate(SlicedCloth<T>& level, const TensionStep<T>& step) {
  for (int slice = 0; slice < level.layout.slices(); ++slice) {
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(LanesOf<T>()))) {
      accelerateLanes(level, step, slice, lane);
    }
  }
}

void accelerateFloat(SlicedCloth<float>& level, const TensionStep<float>& step) {
  accelerate(level, step);
}

void accelerateDouble(SlicedCloth<double>& level, const TensionStep<double>& step) {
  accelerate(level, step);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(accelerateFloat);
HWY_EXPORT(accelerateDouble);

void accelerateByTension(SlicedCloth<float>& level, const TensionStep<float>& step) {
  HWY_DYNAMIC_DISPATCH(accelerateFloat)(level, step);
}

void accelerateByTension(SlicedCloth<double>& level, const TensionStep<double>& step) {
  HWY_DYNAMIC_DISPATCH(accelerateDouble)(level, step);
}

}  // namespace drape::sim::simd
#endif
