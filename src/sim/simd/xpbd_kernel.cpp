// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/xpbd_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/constraint_lanes.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape {
namespace HWY_NAMESPACE {

/// Springs of one colour, as many as there are lanes: eqs. 17 and 18 with numerator and denominator times h^2 k.
template <class D>
HWY_INLINE void projectLanes(D d, ConstraintLanes& constraints, ConstraintLanes::Batch& batch, int lane,
                             hn::Vec<D> inverseCompliance) {
  const auto one = hn::Set(d, 1.0F);
  float* const vertices = constraints.vertices.data();
  const Lanes4<D> a = fetch4(d, vertices, batch.a.data() + lane);
  const Lanes4<D> b = fetch4(d, vertices, batch.b.data() + lane);
  const auto rest = hn::LoadU(d, batch.restLength.data() + lane);
  const auto multiplier = hn::LoadU(d, batch.multiplier.data() + lane);
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

void project(ConstraintLanes& constraints, float inverseCompliance) {
  const LanesOf<float> d;
  const auto compliance = hn::Set(d, inverseCompliance);
  for (ConstraintLanes::Batch& batch : constraints.batches) {
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
      projectLanes(d, constraints, batch, lane, compliance);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace drape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape {

HWY_EXPORT(project);

void projectSprings(ConstraintLanes& constraints, float inverseCompliance) {
  HWY_DYNAMIC_DISPATCH(project)(constraints, inverseCompliance);
}

}  // namespace drape
#endif
