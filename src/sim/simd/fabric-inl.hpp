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

/// One side of a corner.
template <class D>
struct CornerSide {
  Lanes3<D> offset;  // [m]
  hn::Vec<D> q;      // [m^2]
};

/// The side from the vertex to the neighbour of a slot. @param at the slot, counted over all slices
template <class D, typename T>
HWY_INLINE CornerSide<D> sideOfSlot(D d, const SlicedCloth<T>& cloth, std::size_t at, int lane, const Lanes3<D>& x) {
  const Neighbours<D> neighbours(cloth.layout, cloth.layout.slots[at], lane);
  const Lanes3<D> offset = subtract(neighbours.load(cloth.position), x);
  const auto rest = hn::LoadU(d, cloth.restLength[at].data() + lane);
  return {offset, hn::Mul(hn::Set(d, T(0.5)), hn::NegMulAdd(rest, rest, dot(offset, offset)))};
}

/// Stores the offsets of a slice's slots, and q of the sides in alpha, where `storedSide` finds them.
template <class D, typename T>
HWY_INLINE void storeSides(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                           const Lanes3<D>& x) {
  const int end = cloth.layout.slotBegin[slice + 1];
  for (int slot = cloth.layout.slotBegin[slice]; slot < end; ++slot, ++terms) {
    const CornerSide<D> side = sideOfSlot(d, cloth, static_cast<std::size_t>(slot), lane, x);
    storeOffset(d, *terms, lane, side.offset);
    hn::StoreU(side.q, d, terms->alpha.data() + lane);
  }
}

template <class D, typename T>
HWY_INLINE CornerSide<D> storedSide(D d, const SpringTerms<T>* terms, const SliceLayout& layout,
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

/// The tensions of the two sides of a corner, which are one triangle's part.
template <class D>
struct CornerTensions {
  hn::Vec<D> a, b;  // [N/m]
};

/// Computes the tensions at one corner, and adds its part of the energy. The energy of a triangle is sum_e t_e q_e / 2
/// over its sides; each side is seen from two of its corners. @param at the corner, counted over all slices
template <class D, typename T>
HWY_INLINE CornerTensions<D> tensionsOf(D d, const SlicedFabric<T>& fabric, std::size_t at, int lane,
                                        const CornerSide<D>& a, const CornerSide<D>& b, bool wantsEnergy,
                                        hn::Vec<D>& energy) {
  const typename SlicedFabric<T>::Corner& own = fabric.corners[fabric.cornerOf[at]];
  const auto qc = hn::Add(hn::Add(a.q, b.q), hn::Sub(hn::LoadU(d, own.restDot.data() + lane), dot(a.offset, b.offset)));
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
  return {ta, tb};
}

/// Adds the membrane's forces on some lanes of a slice in which not all lanes have the same corners.
template <class D, typename T>
HWY_INLINE void addMembrane(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                            const Lanes3<D>& x, bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  const SliceLayout& layout = cloth.layout;
  storeSides(d, cloth, terms, slice, lane, x);
  const int end = layout.cornerBegin[slice + 1];
  for (int c = layout.cornerBegin[slice]; c < end; ++c) {
    const auto at = static_cast<std::size_t>(c);
    const CornerSide<D> a = storedSide(d, terms, layout, layout.corners[at], false, lane);
    const CornerSide<D> b = storedSide(d, terms, layout, layout.corners[at], true, lane);
    const CornerTensions<D> tensions = tensionsOf(d, *cloth.fabric, at, lane, a, b, wantsEnergy, energy);
    force = multiplyAdd(a.offset, tensions.a, force);
    force = multiplyAdd(b.offset, tensions.b, force);
  }
}

/// The same where all lanes have the same corners. Then most corners follow each other around the vertex, so that each
/// side is computed once and stays in registers.
template <class D, typename T>
HWY_INLINE void addFan(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane, const Lanes3<D>& x,
                       bool keepsOffsets, bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  const SliceLayout& layout = cloth.layout;
  const auto firstSlot = static_cast<std::size_t>(layout.slotBegin[slice]);
  const auto sideAt = [&](std::uint16_t slot) HWY_ATTR {
    const CornerSide<D> side = sideOfSlot(d, cloth, firstSlot + slot, lane, x);
    if (keepsOffsets) {
      storeOffset(d, terms[slot], lane, side.offset);
    }
    return side;
  };
  const int end = layout.cornerBegin[slice + 1];
  int before = -1;  // the slot of `b`
  CornerSide<D> b{{hn::Zero(d), hn::Zero(d), hn::Zero(d)}, hn::Zero(d)};
  auto tension = hn::Zero(d);  // of `b`, from its first triangle
  for (int c = layout.cornerBegin[slice]; c < end; ++c) {
    const SliceLayout::Corner& corner = layout.corners[static_cast<std::size_t>(c)];
    CornerSide<D> a = b;
    if (HWY_UNLIKELY(corner.slotA != before)) {
      force = multiplyAdd(b.offset, tension, force);
      tension = hn::Zero(d);
      a = sideAt(corner.slotA);
    }
    b = sideAt(corner.slotB);
    before = corner.slotB;
    const CornerTensions<D> tensions =
        tensionsOf(d, *cloth.fabric, static_cast<std::size_t>(c), lane, a, b, wantsEnergy, energy);
    force = multiplyAdd(a.offset, hn::Add(tension, tensions.a), force);
    tension = tensions.b;
  }
  force = multiplyAdd(b.offset, tension, force);
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

/// Adds the forces of the fabric on some lanes of a slice, and their part of its energy.
/// @param keepsOffsets whether to leave the offsets of the slots in `terms`
template <class D, typename T>
HWY_INLINE void addFabric(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                          const Lanes3<D>& x, bool keepsOffsets, bool wantsEnergy, Lanes3<D>& force,
                          hn::Vec<D>& energy) {
  if (HWY_LIKELY(cloth.fabric->hasCommonCorners[slice] != 0)) {
    addFan(d, cloth, terms, slice, lane, x, keepsOffsets, wantsEnergy, force, energy);
  } else {
    addMembrane(d, cloth, terms, slice, lane, x, wantsEnergy, force, energy);
  }
  if (cloth.fabric->bending) {
    addBending(d, cloth, slice, lane, x, wantsEnergy, force, energy);
  }
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
