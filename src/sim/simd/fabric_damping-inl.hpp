// Included once for each instruction set, so the usual guard does not serve.
#if defined(DRAPE_SIM_SIMD_FABRIC_DAMPING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_SIM_SIMD_FABRIC_DAMPING_INL_HPP
#undef DRAPE_SIM_SIMD_FABRIC_DAMPING_INL_HPP
#else
#define DRAPE_SIM_SIMD_FABRIC_DAMPING_INL_HPP
#endif

#include "sim/simd/damping_stages.hpp"
#include "sim/simd/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

/// A vertex's neighbour, relative to the vertex.
template <class D>
struct MovingSide {
  Lanes3<D> offset;    // [m]
  Lanes3<D> velocity;  // [m/s]
};

/// The positions and velocities that the rates of strain are computed from.
template <class D>
class MovingSides {
  using T = hn::TFromD<D>;

 public:
  HWY_INLINE MovingSides(const LaneVectors<T>& positions, const LaneVectors<T>& velocities, int at)
      : positions_(positions),
        velocities_(velocities),
        position_(load3(D(), positions, at)),
        velocity_(load3(D(), velocities, at)) {}

  HWY_INLINE MovingSide<D> to(const Neighbours<D>& neighbours) const {
    return {subtract(neighbours.load(positions_), position_), subtract(neighbours.load(velocities_), velocity_)};
  }

 private:
  const LaneVectors<T>& positions_;
  const LaneVectors<T>& velocities_;
  Lanes3<D> position_;
  Lanes3<D> velocity_;
};

/// The damping of stretch and shear at one corner, per damping time [N/s]: the membrane's forces with the rates of q
/// instead of q, without stiffening (SlicedFabric). @param at the corner, counted over all slices
template <class D, typename T>
HWY_INLINE Lanes3<D> addCornerDamping(D d, const SlicedFabric<T>& fabric, std::size_t at, int lane,
                                      const MovingSide<D>& a, const MovingSide<D>& b, const Lanes3<D>& sum) {
  const typename SlicedFabric<T>::Corner& own = fabric.corners[static_cast<std::size_t>(fabric.cornerOf[at])];
  const auto qa = dot(a.offset, a.velocity);
  const auto qb = dot(b.offset, b.velocity);
  const auto qc = hn::Sub(hn::Add(qa, qb), hn::Add(dot(a.offset, b.velocity), dot(b.offset, a.velocity)));
  const auto ab = hn::LoadU(d, own.ab.data() + lane);
  const auto ta = hn::MulAdd(hn::LoadU(d, own.aa.data() + lane), qa,
                             hn::MulAdd(hn::LoadU(d, own.ac.data() + lane), qc, hn::Mul(ab, qb)));
  const auto tb = hn::MulAdd(hn::LoadU(d, own.bb.data() + lane), qb,
                             hn::MulAdd(hn::LoadU(d, own.bc.data() + lane), qc, hn::Mul(ab, qa)));
  return multiplyAdd(b.offset, tb, multiplyAdd(a.offset, ta, sum));
}

/// The same for all corners of a slice whose lanes have the same corners.
template <class D, typename T>
HWY_INLINE Lanes3<D> commonCornerDamping(D d, const SlicedCloth<T>& cloth, const MovingSides<D>& sides, int slice,
                                         int lane) {
  const SliceLayout& layout = cloth.layout;
  const auto firstSlot = static_cast<std::size_t>(layout.slotBegin[slice]);
  const auto sideAt = [&](std::uint16_t slot)
                          HWY_ATTR { return sides.to(Neighbours<D>(layout, layout.slots[firstSlot + slot], lane)); };
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  MovingSide<D> b{sum, sum};
  int before = -1;  // the slot of `b`
  const int end = layout.cornerBegin[slice + 1];
  for (int c = layout.cornerBegin[slice]; c < end; ++c) {
    const SliceLayout::Corner& corner = layout.corners[static_cast<std::size_t>(c)];
    const MovingSide<D> a = corner.slotA == before ? b : sideAt(corner.slotA);
    b = sideAt(corner.slotB);
    before = corner.slotB;
    sum = addCornerDamping(d, *cloth.fabric, static_cast<std::size_t>(c), lane, a, b, sum);
  }
  return sum;
}

/// The same in all other slices, from the fans of the vertices (SlicedFabric::Sector).
template <class D, typename T>
HWY_INLINE Lanes3<D> fanDamping(D d, const SlicedFabric<T>& fabric, const MovingSides<D>& sides, int slice, int lane) {
  const auto& moduli = fabric.moduliOf(slice);
  const auto spoke = [&](int at) HWY_ATTR {
    return sides.to(Neighbours<D>(fabric.spokes[static_cast<std::size_t>(at)], fabric.spokeTables, lane));
  };
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const int begin = fabric.spokeBegin[slice];
  const int end = fabric.spokeBegin[slice + 1];
  if (begin == end) {
    return sum;
  }
  MovingSide<D> b = spoke(begin);
  for (int at = begin + 1; at < end; ++at) {
    const typename SlicedFabric<T>::Sector& sector = fabric.sectors[static_cast<std::size_t>(at)];
    const MovingSide<D> a = b;
    b = spoke(at);
    const auto a1 = hn::LoadU(d, sector.a1.data() + lane);
    const auto a2 = hn::LoadU(d, sector.a2.data() + lane);
    const auto b1 = hn::LoadU(d, sector.b1.data() + lane);
    const auto b2 = hn::LoadU(d, sector.b2.data() + lane);
    const auto area = hn::Abs(hn::LoadU(d, sector.area.data() + lane));
    const Lanes3<D> f1 = multiplyAdd(b.offset, b1, scaled(a.offset, a1));
    const Lanes3<D> f2 = multiplyAdd(b.offset, b2, scaled(a.offset, a2));
    const Lanes3<D> rate1 = multiplyAdd(b.velocity, b1, scaled(a.velocity, a1));
    const Lanes3<D> rate2 = multiplyAdd(b.velocity, b2, scaled(a.velocity, a2));
    const auto e1 = dot(f1, rate1);
    const auto e2 = dot(f2, rate2);
    const auto e12 = hn::Add(dot(f1, rate2), dot(f2, rate1));
    const auto across = hn::LoadU(d, moduli.across.data() + lane);
    const auto s1 = hn::MulAdd(hn::LoadU(d, moduli.warp.data() + lane), e1, hn::Mul(across, e2));
    const auto s2 = hn::MulAdd(hn::LoadU(d, moduli.weft.data() + lane), e2, hn::Mul(across, e1));
    const auto s12 = hn::Mul(hn::LoadU(d, moduli.shear.data() + lane), e12);
    const auto g1 = hn::Mul(area, hn::Add(a1, b1));
    const auto g2 = hn::Mul(area, hn::Add(a2, b2));
    sum = multiplyAdd(f1, hn::MulAdd(s1, g1, hn::Mul(s12, g2)), sum);
    sum = multiplyAdd(f2, hn::MulAdd(s12, g1, hn::Mul(s2, g2)), sum);
  }
  return sum;
}

/// The damping of stretch and shear at some lanes of a slice, per largest damping time of the cloth [N/s].
template <class D, typename T>
HWY_INLINE Lanes3<D> membraneDamping(D d, const SlicedCloth<T>& cloth, const LaneVectors<T>& velocities, int slice,
                                     int lane) {
  const MovingSides<D> sides(cloth.position, velocities, slice * sliceLanes + lane);
  const Lanes3<D> damping = cloth.fabric->hasCommonCorners[slice] != 0
                                ? commonCornerDamping(d, cloth, sides, slice, lane)
                                : fanDamping(d, *cloth.fabric, sides, slice, lane);
  const auto& relative = cloth.fabric->relativeDamping;
  return relative.empty() ? damping : scaled(damping, hn::LoadU(d, relative[slice].data() + lane));
}

/// Delta of fabric::BendingDamping, applied to vectors, at some lanes of a slice.
template <class D, typename T>
HWY_INLINE Lanes3<D> weightedLaplacian(D d, const SliceLayout& layout, const SlicedBendingDamping<T>& bending,
                                       const LaneVectors<T>& vectors, int slice, int lane) {
  const Lanes3<D> own = load3(d, vectors, slice * sliceLanes + lane);
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const int end = layout.slotBegin[slice + 1];
  for (int slot = layout.slotBegin[slice]; slot < end; ++slot) {
    const auto at = static_cast<std::size_t>(slot);
    const Neighbours<D> neighbours(layout, layout.slots[at], lane);
    const auto weight = hn::LoadU(d, bending.weights[at].data() + lane);
    sum = multiplyAdd(subtract(neighbours.load(vectors), own), weight, sum);
  }
  return sum;
}

/// The rates of bending at some lanes of a slice.
template <class D, typename T>
HWY_INLINE void storeBendingRates(D d, const SliceLayout& layout, const LaneVectors<T>& velocities, int slice, int lane,
                                  SlicedBendingDamping<T>& bending) {
  const int i = slice * sliceLanes + lane;
  const Lanes3<D> direction = load3(d, bending.directions, i);
  const auto rate = dot(direction, weightedLaplacian(d, layout, bending, velocities, slice, lane));
  store3(d, scaled(direction, hn::Mul(rate, hn::LoadU(d, bending.inverseAreas.data() + i))), bending.rates, i);
}

/// The damping of bending at some lanes of a slice, per damping time [N/s].
template <class D, typename T>
HWY_INLINE Lanes3<D> bendingDamping(D d, const SliceLayout& layout, const SlicedBendingDamping<T>& bending, int slice,
                                    int lane) {
  return scaled(weightedLaplacian(d, layout, bending, bending.rates, slice, lane), hn::Set(d, T(-1)));
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
