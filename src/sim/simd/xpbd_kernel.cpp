// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/xpbd_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/constraint_lanes.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// Springs of one colour, as many as there are lanes: eqs. 17 and 18 with numerator and denominator times h^2 k.
template <class D>
HWY_INLINE void projectLanes(D d, ConstraintLanes& constraints, ConstraintLanes::Batch& batch, int lane,
                             hn::Vec<D> inverseCompliance, bool first) {
  const auto one = hn::Set(d, 1.0F);
  float* const vertices = constraints.vertices.data();
  const Lanes4<D> a = fetch4(d, vertices, batch.a.data() + lane);
  const Lanes4<D> b = fetch4(d, vertices, batch.b.data() + lane);
  const auto rest = hn::LoadU(d, batch.restLength.data() + lane);
  const auto multiplier = first ? hn::Zero(d) : hn::LoadU(d, batch.multiplier.data() + lane);
  const Lanes3<D> offset = {hn::Sub(b.x, a.x), hn::Sub(b.y, a.y), hn::Sub(b.z, a.z)};
  const auto length = hn::Sqrt(dot(offset, offset));
  const auto directed = hn::Gt(length, hn::Mul(rest, hn::Set(d, 1e-9F)));
  const auto residual = hn::MulAdd(inverseCompliance, hn::Sub(length, rest), multiplier);
  const auto weight = hn::MulAdd(inverseCompliance, hn::Add(a.w, b.w), one);
  const auto change = hn::IfThenElseZero(directed, hn::Neg(hn::Div(residual, weight)));
  hn::StoreU(hn::Add(multiplier, change), d, batch.multiplier.data() + lane);
  const auto along = hn::IfThenElseZero(directed, hn::Div(change, length));
  const auto pullA = hn::Neg(hn::Mul(along, a.w));
  const auto pullB = hn::Mul(along, b.w);
  store4(d, {hn::MulAdd(pullA, offset.x, a.x), hn::MulAdd(pullA, offset.y, a.y), hn::MulAdd(pullA, offset.z, a.z), a.w},
         vertices, batch.a.data() + lane);
  store4(d, {hn::MulAdd(pullB, offset.x, b.x), hn::MulAdd(pullB, offset.y, b.y), hn::MulAdd(pullB, offset.z, b.z), b.w},
         vertices, batch.b.data() + lane);
}

/// Dashpots of one colour, as many as there are lanes.
template <class D>
HWY_INLINE void dampLanes(D d, ConstraintLanes& constraints, const ConstraintLanes::Batch& batch, int lane,
                          hn::Vec<D> strength) {
  float* const velocities = constraints.velocities.data();
  const Lanes4<D> a = fetch4(d, velocities, batch.a.data() + lane);
  const Lanes4<D> b = fetch4(d, velocities, batch.b.data() + lane);
  const auto weight = hn::MulAdd(strength, hn::Add(a.w, b.w), hn::Set(d, 1.0F));
  const auto impulse = hn::Div(strength, weight);
  const Lanes3<D> relative = {hn::Sub(b.x, a.x), hn::Sub(b.y, a.y), hn::Sub(b.z, a.z)};
  const auto pushA = hn::Mul(impulse, a.w);
  const auto pushB = hn::Neg(hn::Mul(impulse, b.w));
  store4(
      d,
      {hn::MulAdd(pushA, relative.x, a.x), hn::MulAdd(pushA, relative.y, a.y), hn::MulAdd(pushA, relative.z, a.z), a.w},
      velocities, batch.a.data() + lane);
  store4(
      d,
      {hn::MulAdd(pushB, relative.x, b.x), hn::MulAdd(pushB, relative.y, b.y), hn::MulAdd(pushB, relative.z, b.z), b.w},
      velocities, batch.b.data() + lane);
}

void projectBatches(ConstraintLanes& constraints, float inverseCompliance, bool first, LaneRange range) {
  const LanesOf<float> d;
  const auto evenly = hn::Set(d, inverseCompliance);
  const auto* const uneven = constraints.relativeStiffness.data();
  for (int i = range.begin; i < range.end; ++i) {
    ConstraintLanes::Batch& batch = constraints.batches[i];
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
      auto compliance = evenly;
      if (HWY_UNLIKELY(uneven != nullptr)) {
        compliance = hn::Mul(evenly, hn::LoadU(d, uneven[i].data() + lane));
      }
      projectLanes(d, constraints, batch, lane, compliance, first);
    }
  }
}

void dampBatches(ConstraintLanes& constraints, float strength, LaneRange range) {
  const LanesOf<float> d;
  const auto strengths = hn::Set(d, strength);
  for (int i = range.begin; i < range.end; ++i) {
    const ConstraintLanes::Batch& batch = constraints.batches[i];
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
      dampLanes(d, constraints, batch, lane, strengths);
    }
  }
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(projectBatches);
HWY_EXPORT(dampBatches);

void projectSprings(ConstraintLanes& constraints, float inverseCompliance, bool first, LaneRange batches) {
  HWY_DYNAMIC_DISPATCH(projectBatches)(constraints, inverseCompliance, first, batches);
}

void dampSprings(ConstraintLanes& constraints, float strength, LaneRange batches) {
  HWY_DYNAMIC_DISPATCH(dampBatches)(constraints, strength, batches);
}

}  // namespace drape::sim::simd
#endif
