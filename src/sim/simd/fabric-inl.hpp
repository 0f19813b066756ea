// Included once for each instruction set, so the usual guard does not serve.
#if defined(DRAPE_SIM_SIMD_FABRIC_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_SIM_SIMD_FABRIC_INL_HPP
#undef DRAPE_SIM_SIMD_FABRIC_INL_HPP
#else
#define DRAPE_SIM_SIMD_FABRIC_INL_HPP
#endif

#include "sim/simd/air-inl.hpp"
#include "sim/simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// Stores the offsets of a slice's slots, and q of the sides in alpha, where `addMembrane` finds them.
template <class D, typename T>
HWY_INLINE void storeSides(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                           const Lanes3<D>& x) {
  const SliceLayout& layout = cloth.layout;
  const auto half = hn::Set(d, T(0.5));
  const int end = layout.slotBegin[slice + 1];
  for (int slot = layout.slotBegin[slice]; slot < end; ++slot, ++terms) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<D> neighbours(layout, layout.slots[at], lane);
    const Lanes3<D> offset = subtract(neighbours.load(cloth.position), x);
    const auto rest = hn::LoadU(d, cloth.restLength[at].data() + lane);
    storeOffset(d, *terms, lane, offset);
    hn::StoreU(hn::Mul(half, hn::NegMulAdd(rest, rest, dot(offset, offset))), d, terms->alpha.data() + lane);
  }
}

/// One side of a corner.
template <class D>
struct CornerSide {
  Lanes3<D> offset;  // [m]
  hn::Vec<D> q;      // [m^2]
};

template <class D, typename T>
HWY_INLINE CornerSide<D> sideOf(D d, const SpringTerms<T>* terms, const SliceLayout& layout,
                                const SliceLayout::Corner& corner, bool second, int lane) {
  if (HWY_LIKELY(corner.table < 0)) {
    const SpringTerms<T>& own = terms[second ? corner.slotB : corner.slotA];
    return {offsetOf(d, own, lane), hn::LoadU(d, own.alpha.data() + lane)};
  }
  const SliceLayout::CornerTable& table = layout.cornerTables[corner.table];
  const auto at = loadCorners(d, (second ? table.b : table.a).data(), lane);
  return {gatherOffsets(d, terms, at), hn::GatherIndex(d, terms->alpha.data(), at)};
}

/// Adds the stiffening of one corner in one direction to the tensions of its sides. Returns s^2.
template <class D, typename Stiffening>
HWY_INLINE hn::Vec<D> addStiffening(D d, const Stiffening& stiffening, int lane, const hn::Vec<D>& qa,
                                    const hn::Vec<D>& qb, const hn::Vec<D>& qc, hn::Vec<D>& ta, hn::Vec<D>& tb) {
  const auto a = hn::LoadU(d, stiffening.a.data() + lane);
  const auto b = hn::LoadU(d, stiffening.b.data() + lane);
  const auto c = hn::LoadU(d, stiffening.c.data() + lane);
  const auto reached = hn::MulAdd(c, qc, hn::MulAdd(b, qb, hn::Mul(a, qa)));
  const auto s = hn::Max(hn::Zero(d), hn::Sub(reached, hn::LoadU(d, stiffening.start.data() + lane)));
  ta = hn::MulAdd(s, a, ta);
  tb = hn::MulAdd(s, b, tb);
  return hn::Mul(s, s);
}

/// Adds the membrane's forces on some lanes of a slice whose sides are stored, and their part of its energy. The energy
/// is sum_e t_e q_e / 2 over the sides of a triangle; each side is seen from two of its corners.
template <class D, typename T>
HWY_INLINE void addMembrane(D d, const SlicedCloth<T>& cloth, const SpringTerms<T>* terms, int slice, int lane,
                            bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  const SliceLayout& layout = cloth.layout;
  const SlicedFabric<T>& fabric = *cloth.fabric;
  const int end = layout.cornerBegin[slice + 1];
  for (int c = layout.cornerBegin[slice]; c < end; ++c) {
    const auto at = static_cast<std::size_t>(c);
    const typename SlicedFabric<T>::Corner& own = fabric.corners[fabric.cornerOf[at]];
    const CornerSide<D> a = sideOf(d, terms, layout, layout.corners[at], false, lane);
    const CornerSide<D> b = sideOf(d, terms, layout, layout.corners[at], true, lane);
    const auto qc =
        hn::Add(hn::Add(a.q, b.q), hn::Sub(hn::LoadU(d, own.restDot.data() + lane), dot(a.offset, b.offset)));
    const auto ab = hn::LoadU(d, own.ab.data() + lane);
    auto ta = hn::MulAdd(hn::LoadU(d, own.aa.data() + lane), a.q,
                         hn::MulAdd(hn::LoadU(d, own.ac.data() + lane), qc, hn::Mul(ab, b.q)));
    auto tb = hn::MulAdd(hn::LoadU(d, own.bb.data() + lane), b.q,
                         hn::MulAdd(hn::LoadU(d, own.bc.data() + lane), qc, hn::Mul(ab, a.q)));
    if (HWY_UNLIKELY(wantsEnergy)) {
      energy = hn::MulAdd(hn::Set(d, T(0.25)), hn::MulAdd(ta, a.q, hn::Mul(tb, b.q)), energy);
    }
    if (HWY_UNLIKELY(!fabric.stiffening.empty())) {
      auto squares = addStiffening(d, fabric.stiffening[at][0], lane, a.q, b.q, qc, ta, tb);
      squares = hn::Add(squares, addStiffening(d, fabric.stiffening[at][1], lane, a.q, b.q, qc, ta, tb));
      energy = hn::MulAdd(hn::Set(d, T(1.0 / 6.0)), squares, energy);
    }
    force = multiplyAdd(a.offset, ta, force);
    force = multiplyAdd(b.offset, tb, force);
  }
}

/// Adds the bending forces on some lanes of a slice, and their part of its energy. The rows of the matrix sum to zero,
/// so that offsets serve instead of positions.
template <class D, typename T>
HWY_INLINE void addBending(D d, const SlicedCloth<T>& cloth, int slice, int lane, const Lanes3<D>& x, bool wantsEnergy,
                           Lanes3<D>& force, hn::Vec<D>& energy) {
  const typename SlicedFabric<T>::Bending& bending = *cloth.fabric->bending;
  const int end = bending.slotBegin[slice + 1];
  for (int slot = bending.slotBegin[slice]; slot < end; ++slot) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<D> neighbours(bending.slots[at], bending.tables, lane);
    const Lanes3<D> offset = subtract(neighbours.load(cloth.position), x);
    const auto entry = hn::LoadU(d, bending.entries[bending.entriesOf[at]].data() + lane);
    force = multiplyAdd(offset, entry, force);
    if (HWY_UNLIKELY(wantsEnergy)) {
      energy = hn::MulAdd(hn::Mul(hn::Set(d, T(0.25)), entry), dot(offset, offset), energy);
    }
  }
}

/// Adds the forces of the fabric on some lanes of a slice, and their part of its energy. Leaves the offsets of the
/// slots in `terms`.
template <class D, typename T>
HWY_INLINE void addFabric(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                          const Lanes3<D>& x, bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  storeSides(d, cloth, terms, slice, lane, x);
  addMembrane(d, cloth, terms, slice, lane, wantsEnergy, force, energy);
  if (cloth.fabric->bending) {
    addBending(d, cloth, slice, lane, x, wantsEnergy, force, energy);
  }
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
