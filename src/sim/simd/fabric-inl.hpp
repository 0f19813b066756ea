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

/// Computes the tensions at one corner, and adds a third of the triangle's energy, which is sum_e t_e q_e / 2 over its
/// sides. @param at the corner, counted over all slices
template <class D, typename T>
HWY_INLINE CornerTensions<D> tensionsOf(D d, const SlicedFabric<T>& fabric, std::size_t at, int lane,
                                        const CornerSide<D>& a, const CornerSide<D>& b, bool wantsEnergy,
                                        hn::Vec<D>& energy) {
  const auto numbers = static_cast<std::size_t>(fabric.cornerOf[at]);
  const typename SlicedFabric<T>::Corner& own = fabric.corners[numbers];
  const auto qc = hn::Add(hn::Add(a.q, b.q), hn::Sub(hn::LoadU(d, own.restDot.data() + lane), dot(a.offset, b.offset)));
  const auto ab = hn::LoadU(d, own.ab.data() + lane);
  auto ta = hn::MulAdd(hn::LoadU(d, own.aa.data() + lane), a.q,
                       hn::MulAdd(hn::LoadU(d, own.ac.data() + lane), qc, hn::Mul(ab, b.q)));
  auto tb = hn::MulAdd(hn::LoadU(d, own.bb.data() + lane), b.q,
                       hn::MulAdd(hn::LoadU(d, own.bc.data() + lane), qc, hn::Mul(ab, a.q)));
  if (HWY_UNLIKELY(wantsEnergy)) {
    const auto tc = hn::MulAdd(
        hn::LoadU(d, own.ac.data() + lane), a.q,
        hn::MulAdd(hn::LoadU(d, own.bc.data() + lane), b.q, hn::Mul(hn::LoadU(d, own.cc.data() + lane), qc)));
    const auto twice = hn::MulAdd(ta, a.q, hn::MulAdd(tb, b.q, hn::Mul(tc, qc)));
    energy = hn::MulAdd(hn::Set(d, T(1.0 / 6.0)), twice, energy);
  }
  if (HWY_UNLIKELY(!fabric.stiffening.empty())) {
    auto squares = addStiffening(d, fabric.stiffening[numbers][0], lane, a.q, b.q, qc, ta, tb);
    squares = hn::Add(squares, addStiffening(d, fabric.stiffening[numbers][1], lane, a.q, b.q, qc, ta, tb));
    energy = hn::MulAdd(hn::Set(d, T(1.0 / 6.0)), squares, energy);
  }
  return {ta, tb};
}

/// Adds the membrane's forces on some lanes of a slice in which all lanes have the same corners. Most corners follow
/// each other around the vertex, so that each side is computed once and stays in registers.
template <class D, typename T>
HWY_INLINE void addCommonCorners(D d, const SlicedCloth<T>& cloth, SpringTerms<T>* terms, int slice, int lane,
                                 const Lanes3<D>& x, bool keepsOffsets, bool wantsEnergy, Lanes3<D>& force,
                                 hn::Vec<D>& energy) {
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

/// Adds the membrane's forces on some lanes of a slice from the fans of its vertices, see SlicedFabric::Sector.
/// @param area receives twice the sum of the area vectors of each vertex's triangles
template <class D, typename T>
HWY_INLINE void addFans(D d, const SlicedCloth<T>& cloth, int slice, int lane, const Lanes3<D>& x, bool wantsEnergy,
                        Lanes3<D>& force, hn::Vec<D>& energy, Lanes3<D>& area) {
  const SlicedFabric<T>& fabric = *cloth.fabric;
  const auto& moduli = fabric.moduliOf(slice);
  const auto one = hn::Set(d, T(1));
  const auto half = hn::Set(d, T(0.5));
  const auto spoke = [&](int at) HWY_ATTR {
    const Neighbours<D> neighbours(fabric.spokes[static_cast<std::size_t>(at)], fabric.spokeTables, lane);
    return subtract(neighbours.load(cloth.position), x);
  };
  const int begin = fabric.spokeBegin[slice];
  const int end = fabric.spokeBegin[slice + 1];
  area = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  if (begin == end) {
    return;
  }
  Lanes3<D> b = spoke(begin);
  for (int at = begin + 1; at < end; ++at) {
    const typename SlicedFabric<T>::Sector& sector = fabric.sectors[static_cast<std::size_t>(at)];
    const Lanes3<D> a = b;
    b = spoke(at);
    const auto a1 = hn::LoadU(d, sector.a1.data() + lane);
    const auto a2 = hn::LoadU(d, sector.a2.data() + lane);
    const auto b1 = hn::LoadU(d, sector.b1.data() + lane);
    const auto b2 = hn::LoadU(d, sector.b2.data() + lane);
    const auto turned = hn::LoadU(d, sector.area.data() + lane);
    const auto rest = hn::Abs(turned);
    const Lanes3<D> f1 = multiplyAdd(b, b1, scaled(a, a1));
    const Lanes3<D> f2 = multiplyAdd(b, b2, scaled(a, a2));
    const auto e1 = hn::Mul(half, hn::Sub(dot(f1, f1), one));
    const auto e2 = hn::Mul(half, hn::Sub(dot(f2, f2), one));
    const auto e12 = dot(f1, f2);
    const auto across = hn::LoadU(d, moduli.across.data() + lane);
    auto s1 = hn::MulAdd(hn::LoadU(d, moduli.warp.data() + lane), e1, hn::Mul(across, e2));
    auto s2 = hn::MulAdd(hn::LoadU(d, moduli.weft.data() + lane), e2, hn::Mul(across, e1));
    const auto s12 = hn::Mul(hn::LoadU(d, moduli.shear.data() + lane), e12);
    auto twice = hn::Zero(d);  // twice the energy per area [J/m^2]
    if (HWY_UNLIKELY(wantsEnergy)) {
      twice = hn::MulAdd(s1, e1, hn::MulAdd(s2, e2, hn::Mul(s12, e12)));
    }
    if (moduli.stiffens) {
      const auto limit = hn::LoadU(d, moduli.stiffeningStrain.data() + lane);
      const auto beyond1 = hn::Max(hn::Zero(d), hn::Sub(e1, limit));
      const auto beyond2 = hn::Max(hn::Zero(d), hn::Sub(e2, limit));
      const auto more1 = hn::Mul(hn::LoadU(d, moduli.stiffeningWarp.data() + lane), beyond1);
      const auto more2 = hn::Mul(hn::LoadU(d, moduli.stiffeningWeft.data() + lane), beyond2);
      s1 = hn::Add(s1, more1);
      s2 = hn::Add(s2, more2);
      twice = hn::MulAdd(more1, beyond1, hn::MulAdd(more2, beyond2, twice));
    }
    // A vertex is the start of both sides, so its force has the sum of their derivatives.
    const auto g1 = hn::Mul(rest, hn::Add(a1, b1));
    const auto g2 = hn::Mul(rest, hn::Add(a2, b2));
    force = multiplyAdd(f1, hn::MulAdd(s1, g1, hn::Mul(s12, g2)), force);
    force = multiplyAdd(f2, hn::MulAdd(s12, g1, hn::Mul(s2, g2)), force);
    if (HWY_UNLIKELY(wantsEnergy)) {
      energy = hn::MulAdd(hn::Mul(hn::Set(d, T(1.0 / 6.0)), rest), twice, energy);
    }
    const auto side = hn::IfThenElseZero(hn::Gt(rest, hn::Zero(d)), hn::CopySign(one, turned));
    area = multiplyAdd(addCross(a, b, Lanes3<D>{hn::Zero(d), hn::Zero(d), hn::Zero(d)}), side, area);
  }
}

/// Adds the bending forces on some lanes of a slice times a weight, and the part of its energy. The rows of the matrix
/// sum to zero, so that offsets serve instead of positions.
template <class D, typename T>
HWY_INLINE void addBending(D d, const SlicedCloth<T>& cloth, int slice, int lane, const Lanes3<D>& x, T weight,
                           bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  const typename SlicedFabric<T>::Bending& bending = *cloth.fabric->bending;
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const int end = bending.slotBegin[slice + 1];
  for (int slot = bending.slotBegin[slice]; slot < end; ++slot) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<D> neighbours(bending.slots[at], bending.tables, lane);
    const Lanes3<D> offset = subtract(neighbours.load(cloth.position), x);
    const auto entry = hn::LoadU(d, bending.entries[bending.entriesOf[at]].data() + lane);
    sum = multiplyAdd(offset, entry, sum);
    if (HWY_UNLIKELY(wantsEnergy)) {
      energy = hn::MulAdd(hn::Mul(hn::Set(d, T(0.25)), entry), dot(offset, offset), energy);
    }
  }
  force = multiplyAdd(sum, hn::Set(d, weight), force);
}

/// Adds the forces of the rest moments on some lanes of a slice times a weight, and the part of their energy, but for a
/// constant.
template <class D, typename T>
HWY_INLINE void addMoments(D d, const SlicedCloth<T>& cloth, int slice, int lane, const Lanes3<D>& x, T weight,
                           bool wantsEnergy, Lanes3<D>& force, hn::Vec<D>& energy) {
  const SlicedFabric<T>& fabric = *cloth.fabric;
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const int end = fabric.momentBegin[slice + 1];
  for (int row = fabric.momentBegin[slice]; row < end; ++row) {
    const typename SlicedFabric<T>::RestMoment& moment = fabric.moments[static_cast<std::size_t>(row)];
    const auto load = [&](const SliceLayout::NeighbourTable& table)
                          HWY_ATTR { return Neighbours<D>(table, lane).load(cloth.position); };
    const Lanes3<D> a = load(moment.others[0]);
    const Lanes3<D> gradient = addCross(subtract(load(moment.others[1]), a), subtract(load(moment.others[2]), a),
                                        Lanes3<D>{hn::Zero(d), hn::Zero(d), hn::Zero(d)});
    const auto modulus = hn::LoadU(d, moment.modulus.data() + lane);
    sum = multiplyAdd(gradient, modulus, sum);
    if (HWY_UNLIKELY(wantsEnergy)) {
      const auto quarter = hn::Mul(hn::Set(d, T(-0.25)), modulus);
      energy = hn::MulAdd(quarter, dot(subtract(x, a), gradient), energy);
    }
  }
  force = multiplyAdd(sum, hn::Set(d, weight), force);
}

/// Adds the forces of the fabric and of the air on some lanes of a slice, and the part of the fabric's energy.
/// @param hasAir whether the air has a force
template <class D, typename T>
HWY_INLINE void addFabric(D d, const SlicedCloth<T>& cloth, const SliceStep<T>& step, SpringTerms<T>* terms, int slice,
                          int lane, const Lanes3<D>& x, bool hasAir, Lanes3<D>& force, hn::Vec<D>& energy) {
  const bool wantsEnergy = step.energy != nullptr;
  const bool airActs = hasAir && step.airWeight > T(0);
  Lanes3<D> area{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  if (HWY_LIKELY(cloth.fabric->hasCommonCorners[slice] != 0)) {
    addCommonCorners(d, cloth, terms, slice, lane, x, airActs, wantsEnergy, force, energy);
    if (airActs) {
      area = areaNormal(d, cloth, terms, slice, lane);
    }
  } else {
    addFans(d, cloth, slice, lane, x, wantsEnergy, force, energy, area);
  }
  if (cloth.fabric->bending && (step.bendingWeight > T(0) || wantsEnergy)) {
    addBending(d, cloth, slice, lane, x, step.bendingWeight, wantsEnergy, force, energy);
    if (HWY_UNLIKELY(!cloth.fabric->moments.empty())) {
      addMoments(d, cloth, slice, lane, x, step.bendingWeight, wantsEnergy, force, energy);
    }
  }
  if (airActs) {
    const Lanes3<D> air = airForce(d, cloth, step, step.timeStep * step.airWeight, area, slice, lane, force);
    force = multiplyAdd(air, hn::Set(d, step.airWeight), force);
  }
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
