// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/conjugate_gradients_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/assembly-inl.hpp"
#include "sim/simd/conjugate_gradients.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// The inverse of a diagonal block, zero where pinned. A preconditioner must be positive definite, but with an
/// indefinite force derivative a block may not be. It is then replaced by its Frobenius norm times the identity.
template <class D>
HWY_INLINE Symmetric<D> preconditionerOf(D d, const Symmetric<D>& block, hn::Vec<D> free) {
  const auto zero = hn::Zero(d);
  const auto minor = hn::NegMulAdd(block.xy, block.xy, hn::Mul(block.xx, block.yy));
  const auto definite =
      hn::And(hn::Gt(block.xx, zero), hn::And(hn::Gt(minor, zero), hn::Gt(block.determinant(), zero)));
  Symmetric<D> inverse = block.inverse(free);
  if (HWY_LIKELY(hn::AllTrue(d, definite))) {
    return inverse;
  }
  const auto size = hn::Div(free, hn::Sqrt(block.squaredNorm()));
  return {hn::IfThenElse(definite, inverse.xx, size), hn::IfThenElseZero(definite, inverse.xy),
          hn::IfThenElseZero(definite, inverse.xz),   hn::IfThenElse(definite, inverse.yy, size),
          hn::IfThenElseZero(definite, inverse.yz),   hn::IfThenElse(definite, inverse.zz, size)};
}

// | here             | Baraff and Witkin (1998, sec. 5.3)                       |
// |------------------|----------------------------------------------------------|
// | change           | Delta v, from zero                                       |
// | residual         | r = filter(b - A Delta v)                                |
// | direction        | c                                                        |
// | product          | q = filter(A c)                                          |
// | scaled           | s = filter(P^-1 r), P the diagonal blocks of A           |
template <typename T>
class ConjugateKernel {
  using D = LanesOf<T>;
  using V = hn::Vec<D>;
  using V3 = Lanes3<D>;

 public:
  ConjugateKernel(SlicedCloth<T>& cloth, ConjugateGradients<T>& system, const SliceStep<T>& step,
                  const StepShare& share)
      : cloth_(cloth), layout_(cloth.layout), system_(system), step_(step), share_(share) {}

  void run(ConjugatePhase phase, T factor) {
    const V f = hn::Set(D(), factor);
    switch (phase) {
      case ConjugatePhase::Start:
        return eachLanes([&](int slice, int lane) { startLanes(slice, lane); });
      case ConjugatePhase::Multiply:
        return eachLanes([&](int slice, int lane) { multiplyLanes(slice, lane); });
      case ConjugatePhase::Descend:
        return eachLanes([&](int slice, int lane) { descendLanes(slice, lane, f); });
      case ConjugatePhase::Turn:
        return eachLanes([&](int slice, int lane) { turnLanes(slice * sliceLanes + lane, f); });
      case ConjugatePhase::Advance:
        return eachLanes([&](int slice, int lane) { advanceLanes(slice * sliceLanes + lane); });
    }
  }

 private:
  template <typename Visit>
  HWY_INLINE void eachLanes(Visit&& visit) {
    for (int slice = share_.begin; slice < share_.end; ++slice) {
      for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(D()))) {
        visit(slice, lane);
      }
    }
  }

  /// Adds a slice's numbers to those of its block.
  HWY_INLINE void sum(std::vector<SliceNumbers<T>>& blocks, int slice, int lane, V value) {
    const D d;
    T* const to = blocks[slice / blockSlices].data() + lane;
    hn::StoreU(slice % blockSlices == 0 ? value : hn::Add(hn::LoadU(d, to), value), d, to);
  }

  HWY_INLINE void startLanes(int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    SpringTerms<T>* const terms = system_.terms.data() + layout_.slotBegin[slice];
    const Assembled<D> row = assembleRow(d, cloth_, step_, terms, slice, lane);
    const V free = hn::LoadU(d, cloth_.free.data() + i);
    const Symmetric<D> inverse = preconditionerOf(d, row.matrix, free);
    const V3 residual = scaled(row.force, hn::Mul(free, hn::Set(d, step_.timeStep)));
    const V3 answer = inverse.times(residual);
    storeSymmetric(d, inverse, system_.preconditioner[slice], lane);
    hn::StoreU(row.diagonal, d, system_.diagonal.data() + i);
    store3(d, {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, system_.change, i);
    store3(d, residual, system_.residual, i);
    store3(d, answer, system_.scaled, i);
    store3(d, answer, system_.direction, i);
    sum(system_.descents, slice, lane, dot(residual, answer));
    sum(system_.norms, slice, lane, dot(residual, residual));
  }

  /// A c = m c_i + h sum_j (alpha I + beta o o^T) (c_i - c_j), where m includes the attachment's stiffness.
  HWY_INLINE void multiplyLanes(int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    const V3 own = load3(d, system_.direction, i);
    V3 drawn = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    const int end = layout_.slotBegin[slice + 1];
    for (int slot = layout_.slotBegin[slice]; slot < end; ++slot) {
      const auto at = static_cast<std::size_t>(slot);
      const SpringTerms<T>& terms = system_.terms[at];
      const V3 apart = subtract(own, Neighbours<D>(layout_, layout_.slots[at], lane).load(system_.direction));
      const V3 offset = offsetOf(d, terms, lane);
      drawn = multiplyAdd(apart, hn::LoadU(d, terms.alpha.data() + lane), drawn);
      drawn = multiplyAdd(offset, hn::Mul(hn::LoadU(d, terms.beta.data() + lane), dot(offset, apart)), drawn);
    }
    const V free = hn::LoadU(d, cloth_.free.data() + i);
    const V3 ofDiagonal = scaled(own, hn::LoadU(d, system_.diagonal.data() + i));
    const V3 product = scaled(multiplyAdd(drawn, hn::Set(d, step_.timeStep), ofDiagonal), free);
    store3(d, product, system_.product, i);
    sum(system_.curvatures, slice, lane, dot(own, product));
  }

  HWY_INLINE void descendLanes(int slice, int lane, V length) {
    const D d;
    const int i = slice * sliceLanes + lane;
    store3(d, multiplyAdd(load3(d, system_.direction, i), length, load3(d, system_.change, i)), system_.change, i);
    const V3 residual = multiplyAdd(load3(d, system_.product, i), hn::Neg(length), load3(d, system_.residual, i));
    const V3 answer = loadSymmetric(d, system_.preconditioner[slice], lane).times(residual);
    store3(d, residual, system_.residual, i);
    store3(d, answer, system_.scaled, i);
    sum(system_.descents, slice, lane, dot(residual, answer));
    sum(system_.norms, slice, lane, dot(residual, residual));
  }

  HWY_INLINE void turnLanes(int i, V share) {
    const D d;
    store3(d, multiplyAdd(load3(d, system_.direction, i), share, load3(d, system_.scaled, i)), system_.direction, i);
  }

  HWY_INLINE void advanceLanes(int i) {
    const D d;
    const V3 v = add(load3(d, system_.change, i), load3(d, cloth_.velocity, i));
    store3(d, v, cloth_.velocity, i);
    store3(d, multiplyAdd(v, hn::Set(d, step_.timeStep), load3(d, cloth_.position, i)), cloth_.position, i);
  }

  SlicedCloth<T>& cloth_;
  const SliceLayout& layout_;
  ConjugateGradients<T>& system_;
  const SliceStep<T>& step_;
  const StepShare& share_;
};

void conjugateFloat(SlicedCloth<float>& cloth, ConjugateGradients<float>& system, const SliceStep<float>& step,
                    const StepShare& share, ConjugatePhase phase, float factor) {
  ConjugateKernel<float>(cloth, system, step, share).run(phase, factor);
}

void conjugateDouble(SlicedCloth<double>& cloth, ConjugateGradients<double>& system, const SliceStep<double>& step,
                     const StepShare& share, ConjugatePhase phase, double factor) {
  ConjugateKernel<double>(cloth, system, step, share).run(phase, factor);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(conjugateFloat);
HWY_EXPORT(conjugateDouble);

void conjugatePhase(SlicedCloth<float>& cloth, ConjugateGradients<float>& system, const SliceStep<float>& step,
                    const StepShare& share, ConjugatePhase phase, float factor) {
  HWY_DYNAMIC_DISPATCH(conjugateFloat)(cloth, system, step, share, phase, factor);
}

void conjugatePhase(SlicedCloth<double>& cloth, ConjugateGradients<double>& system, const SliceStep<double>& step,
                    const StepShare& share, ConjugatePhase phase, double factor) {
  HWY_DYNAMIC_DISPATCH(conjugateDouble)(cloth, system, step, share, phase, factor);
}

}  // namespace drape::sim::simd
#endif
