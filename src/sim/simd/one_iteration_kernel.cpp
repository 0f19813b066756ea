// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/simd/one_iteration_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/simd/assembly-inl.hpp"
#include "sim/simd/lanes-inl.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/simd/step_share.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

// | here          | paper                                                                              |
// |---------------|------------------------------------------------------------------------------------|
// | alpha, beta   | h J'_ij = alpha I + beta o o^T with o = x_j - x_i: eqs. 13 and 16 in two numbers   |
// | W             | W'_ii = M_i + h sum_j (alpha I + beta o o^T) (eqs. 10, 13)                         |
// | force         | f~_i (eqs. 8, 14, 18-20)                                                           |
// | start         | p_i = h W_ii^-1 f~_i                                                               |
// | dv            | dv_i = p_i + W_ii^-1 h sum_j (alpha dv_j + beta o (o . dv_j)) (eqs. 11, 13)        |
template <typename T>
class OneIterationKernel {
  using D = LanesOf<T>;
  using V = hn::Vec<D>;
  using V3 = Lanes3<D>;

 public:
  OneIterationKernel(SlicedCloth<T>& cloth, const SliceStep<T>& step, const StepShare& share)
      : cloth_(cloth),
        layout_(cloth.layout),
        step_(step),
        share_(share),
        terms_(cloth.terms[share.member].data()),
        inverses_(cloth.inverses[share.member].data()) {}

  /// Every sweep lags behind the previous one by the bandwidth of the springs, so that its data are still in the cache.
  /// The slices at the ends of a thread's share depend on other threads and are left to later phases.
  void firstPhase() {
    const int last = step_.sweeps;
    std::vector<int>& done = cloth_.done[share_.member];
    done.resize(static_cast<std::size_t>(last) + 1);
    for (int sweep = 0; sweep <= last; ++sweep) {
      done[sweep] = share_.innerBegin(sweep);
    }
    int assembled = share_.begin;
    while (assembled < share_.end) {
      assemble(assembled++);
      int before = assembled;
      for (int sweep = 1; sweep <= last; ++sweep) {
        int& next = done[sweep];
        while (next < share_.innerEnd(sweep) && layout_.lastNeighbourSlice[next] < before) {
          relax(sweep, next++);
        }
        before = next;
      }
    }
  }

  /// The slices at the ends of the share, after all threads have finished the previous sweep.
  void laterPhase(int sweep) {
    for (int slice = share_.begin; slice < share_.innerBegin(sweep); ++slice) {
      relax(sweep, slice);
    }
    for (int slice = share_.innerEnd(sweep); slice < share_.end; ++slice) {
      relax(sweep, slice);
    }
  }

 private:
  [[nodiscard]] SpringTerms<T>* termsOf(int slice) const {
    return terms_ + static_cast<std::ptrdiff_t>(share_.ringSlot(slice)) * layout_.maxSlots;
  }

  HWY_INLINE void assemble(int slice) {
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      assembleLanes(slice, lane);
    }
  }

  HWY_INLINE void relax(int sweep, int slice) {
    for (int lane = 0; lane < sliceLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      relaxLanes(sweep, slice, lane);
    }
  }

  /// p_i = h W_ii^-1 f~_i. The inverse is zero at a pinned vertex.
  HWY_INLINE void assembleLanes(int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    const Assembled<D> row = assembleRow(d, cloth_, step_, termsOf(slice), slice, lane);
    const Symmetric<D> inverse = row.matrix.inverse(hn::LoadU(d, cloth_.free.data() + i));
    storeSymmetric(d, inverse, inverses_[share_.ringSlot(slice)], lane);
    store3(d, inverse.times(scaled(row.force, hn::Set(d, step_.timeStep))), cloth_.start, i);
  }

  HWY_INLINE void relaxLanes(int sweep, int slice, int lane) {
    const D d;
    const int i = slice * sliceLanes + lane;
    const LaneVectors<T>& before = sweep == 1 ? cloth_.start : cloth_.change[static_cast<std::size_t>(sweep - 1) % 2];
    V3 sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    const auto* terms = termsOf(slice);
    const int end = layout_.slotBegin[slice + 1];
    for (int slot = layout_.slotBegin[slice]; slot < end; ++slot, ++terms) {
      const Neighbours<D> neighbours(layout_, layout_.slots[slot], lane);
      const V3 dv = neighbours.load(before);
      const V3 offset = offsetOf(d, *terms, lane);
      sum = multiplyAdd(dv, hn::LoadU(d, terms->alpha.data() + lane), sum);
      sum = multiplyAdd(offset, hn::Mul(hn::LoadU(d, terms->beta.data() + lane), dot(offset, dv)), sum);
    }
    // Damped Jacobi starts from the relaxed p.
    const T scale = sweep == 1 ? step_.timeStep * step_.relaxation : step_.timeStep;
    const V3 start = load3(d, cloth_.start, i);
    const V3 moved = loadSymmetric(d, inverses_[share_.ringSlot(slice)], lane).times(scaled(sum, hn::Set(d, scale)));
    V3 dv = add(moved, start);
    if (step_.weights != nullptr) {
      dv = accelerated(sweep, i, dv);
    } else if (step_.relaxation != T(1)) {
      const V3 old = scaled(load3(d, before, i), hn::Set(d, sweep == 1 ? step_.relaxation : T(1)));
      dv = multiplyAdd(subtract(dv, old), hn::Set(d, step_.relaxation), old);
    }
    if (sweep < step_.sweeps) {
      store3(d, dv, cloth_.change[static_cast<std::size_t>(sweep) % 2], i);
    } else {
      advanceLanes(i, dv);
    }
  }

  /// x_(k+1) = w (answer - x_(k-1)) + x_(k-1), with x_(-1) = 0.
  HWY_INLINE V3 accelerated(int sweep, int i, const V3& answer) {
    const D d;
    V3 old = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    if (sweep == 2) {
      old = load3(d, cloth_.start, i);
    } else if (sweep > 2) {
      old = load3(d, cloth_.change[static_cast<std::size_t>(sweep) % 2], i);
    }
    return multiplyAdd(subtract(answer, old), hn::Set(d, step_.weights[sweep - 1]), old);
  }

  /// v += dv, x += h v. No later slice reads the old values of this slice, since the spring graph is symmetric.
  HWY_INLINE void advanceLanes(int i, const V3& dv) {
    const D d;
    const V3 v = add(dv, load3(d, cloth_.velocity, i));
    store3(d, v, cloth_.velocity, i);
    store3(d, multiplyAdd(v, hn::Set(d, step_.timeStep), load3(d, cloth_.position, i)), cloth_.position, i);
  }

  SlicedCloth<T>& cloth_;
  const SliceLayout& layout_;
  const SliceStep<T>& step_;
  const StepShare& share_;
  SpringTerms<T>* terms_;
  SliceMatrices<T>* inverses_;
};

template <typename T>
void runPhase(SlicedCloth<T>& cloth, const SliceStep<T>& step, const StepShare& share, int phase) {
  OneIterationKernel<T> kernel(cloth, step, share);
  phase == 0 ? kernel.firstPhase() : kernel.laterPhase(phase);
}

void oneIterationFloat(SlicedCloth<float>& cloth, const SliceStep<float>& step, const StepShare& share, int phase) {
  runPhase(cloth, step, share, phase);
}

void oneIterationDouble(SlicedCloth<double>& cloth, const SliceStep<double>& step, const StepShare& share, int phase) {
  runPhase(cloth, step, share, phase);
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::simd {

HWY_EXPORT(oneIterationFloat);
HWY_EXPORT(oneIterationDouble);

void oneIterationPhase(SlicedCloth<float>& cloth, const SliceStep<float>& step, const StepShare& share, int phase) {
  HWY_DYNAMIC_DISPATCH(oneIterationFloat)(cloth, step, share, phase);
}

void oneIterationPhase(SlicedCloth<double>& cloth, const SliceStep<double>& step, const StepShare& share, int phase) {
  HWY_DYNAMIC_DISPATCH(oneIterationDouble)(cloth, step, share, phase);
}

}  // namespace drape::sim::simd
#endif
