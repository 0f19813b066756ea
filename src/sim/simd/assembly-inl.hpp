// Included once for each instruction set, so the usual guard does not serve.
#if defined(DRAPE_SIM_SIMD_ASSEMBLY_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_SIM_SIMD_ASSEMBLY_INL_HPP
#undef DRAPE_SIM_SIMD_ASSEMBLY_INL_HPP
#else
#define DRAPE_SIM_SIMD_ASSEMBLY_INL_HPP
#endif

#include "sim/simd/air-inl.hpp"
#include "sim/simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// The row of the backward-Euler system for the vertex of each lane.
template <class D>
struct Assembled {
  Lanes3<D> force;      // f~_i (eqs. 8, 14, 18-20), with the attachment's force [N]
  Symmetric<D> matrix;  // W'_ii = M_i + h sum_j (alpha I + beta o o^T) (eqs. 10, 13) [kg]
  hn::Vec<D> diagonal;  // M_i plus h^2 times the stiffness of the attachment [kg]
};

/// Evaluates springs, air and attachment for some lanes of a slice. Stores the terms of the springs in `terms`, one
/// entry a slot of the slice.
template <class D, typename T>
HWY_INLINE Assembled<D> assembleRow(D d, const SlicedCloth<T>& cloth, const SliceStep<T>& step,
                                    SpringTerms<T>* HWY_RESTRICT terms, int slice, int lane) {
  const SliceLayout& layout = cloth.layout;
  const int i = slice * sliceLanes + lane;
  const Lanes3<D> x = load3(d, cloth.position, i);
  const Lanes3<D> v = load3(d, cloth.velocity, i);
  hn::Vec<D> diagonal = hn::LoadU(d, cloth.mass.data() + i);
  Lanes3<D> force = {hn::Zero(d), hn::Neg(hn::Mul(diagonal, hn::Set(d, step.gravity))), hn::Zero(d)};
  Symmetric<D> coupled = Symmetric<D>::zero(d);
  const SpringConstants<D> constants(d, step);
  const auto* const uneven = cloth.relativeStiffness.empty() ? nullptr : cloth.relativeStiffness.data();
  const int begin = layout.slotBegin[slice];
  const int end = layout.slotBegin[slice + 1];
  for (int slot = begin; slot < end; ++slot) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<D> neighbours(layout, layout.slots[at], lane);
    const Lanes3<D> offset = subtract(neighbours.load(cloth.position), x);
    const Lanes3<D> relative = subtract(neighbours.load(cloth.velocity), v);
    const auto rest = hn::LoadU(d, cloth.restLength[at].data() + lane);
    const auto spring = HWY_UNLIKELY(uneven != nullptr)
                            ? springLanes(d, constants.times(hn::LoadU(d, uneven[at].data() + lane)), offset, rest)
                            : springLanes(d, constants, offset, rest);
    force = multiplyAdd(offset, hn::MulAdd(spring.beta, dot(offset, relative), spring.elastic), force);
    force = multiplyAdd(relative, spring.alpha, force);
    coupled.add(spring.alpha, spring.beta, offset);
    storeTerms(d, terms[slot - begin], lane, offset, spring);
  }
  if (step.drag != T(0) || step.lift != T(0)) {
    force = addAir(d, cloth, step, terms, slice, lane, force);
  }
  addAttachment(d, step, slice, lane, force, diagonal);
  const hn::Vec<D> h = hn::Set(d, step.timeStep);
  return {force,
          {hn::MulAdd(h, coupled.xx, diagonal), hn::Mul(h, coupled.xy), hn::Mul(h, coupled.xz),
           hn::MulAdd(h, coupled.yy, diagonal), hn::Mul(h, coupled.yz), hn::MulAdd(h, coupled.zz, diagonal)},
          diagonal};
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
