// Included once for each instruction set, so the usual guard does not serve.
#if defined(DRAPE_SIM_SIMD_AIR_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_SIM_SIMD_AIR_INL_HPP
#undef DRAPE_SIM_SIMD_AIR_INL_HPP
#else
#define DRAPE_SIM_SIMD_AIR_INL_HPP
#endif

#include "sim/simd/lanes-inl.hpp"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

constexpr std::uint16_t allLanes = 0xFFFF;

/// The lanes whose bits are set, from `lane` on.
template <class D>
HWY_INLINE hn::Mask<D> lanesOfBits(D d, std::uint16_t bits, int lane) {
  std::uint64_t shifted = static_cast<std::uint64_t>(bits) >> static_cast<unsigned>(lane);
  std::array<std::uint8_t, sizeof(shifted)> bytes{};
  std::memcpy(bytes.data(), &shifted, sizeof(shifted));
  return hn::LoadMaskBits(d, bytes.data());
}

/// Indices of the numbers of the lanes from `lane` on, in a slot of its own for each lane.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> loadCorners(D, const std::uint16_t* slots, int lane) {
  static_assert(SpringTerms<hn::TFromD<D>>::stride == 64 + 16);
  const hn::Rebind<std::int32_t, D> indices;
  const auto slot = hn::PromoteTo(indices, hn::LoadU(hn::Rebind<std::uint16_t, D>(), slots + lane));
  const auto at = hn::Add(hn::Add(hn::ShiftLeft<6>(slot), hn::ShiftLeft<4>(slot)), hn::Iota(indices, lane));
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    return at;
  } else {
    return hn::PromoteTo(hn::RebindToSigned<D>(), at);
  }
}

/// Offsets to the neighbours, in a slot of its own for each lane.
template <class D, typename T>
HWY_INLINE Lanes3<D> gatherOffsets(D d, const SpringTerms<T>* terms, hn::Vec<hn::RebindToSigned<D>> at) {
  return {hn::GatherIndex(d, terms->x.data(), at), hn::GatherIndex(d, terms->y.data(), at),
          hn::GatherIndex(d, terms->z.data(), at)};
}

/// Twice the sum of the area vectors of each vertex's triangles, the same sum as in vertexNormal.
template <class D, typename T>
HWY_INLINE Lanes3<D> areaNormal(D d, const SlicedCloth<T>& cloth, const SpringTerms<T>* terms, int slice, int lane) {
  const SliceLayout& layout = cloth.layout;
  Lanes3<D> sum = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const int end = layout.cornerBegin[slice + 1];
  for (int c = layout.cornerBegin[slice]; c < end; ++c) {
    const SliceLayout::Corner& corner = layout.corners[c];
    Lanes3<D> a;
    Lanes3<D> b;
    if (HWY_LIKELY(corner.table < 0)) {
      a = offsetOf(d, terms[corner.slotA], lane);
      b = offsetOf(d, terms[corner.slotB], lane);
    } else {
      const auto& table = layout.cornerTables[corner.table];
      a = gatherOffsets(d, terms, loadCorners(d, table.a.data(), lane));
      b = gatherOffsets(d, terms, loadCorners(d, table.b.data(), lane));
    }
    if (HWY_UNLIKELY(corner.lanes != allLanes)) {
      const auto present = lanesOfBits(d, corner.lanes, lane);
      b = {hn::IfThenElseZero(present, b.x), hn::IfThenElseZero(present, b.y), hn::IfThenElseZero(present, b.z)};
    }
    sum = addCross(a, b, sum);
  }
  return sum;
}

/// Scales a force down to the one that stops the vertex relative to the air within `timeStep`, as kernels::airForce.
template <class D, typename T>
HWY_INLINE Lanes3<D> limitedAirForce(D d, const Lanes3<D>& air, T timeStep, const hn::Vec<D>& mass,
                                     const hn::Vec<D>& speed) {
  const auto limit = hn::Mul(mass, hn::Mul(speed, hn::Set(d, T(1) / timeStep)));
  const auto strength = dot(air, air);
  const auto excessive = hn::Gt(strength, hn::Mul(limit, limit));
  if (HWY_LIKELY(hn::AllFalse(d, excessive))) {
    return air;
  }
  const auto scale = hn::Div(limit, hn::Sqrt(strength));
  return scaled(air, hn::IfThenElse(excessive, scale, hn::Set(d, T(1))));
}

/// The force on a thin plate (kernels::plateForce) [N]. @param relative to the air [m/s]  @param normal unit vector
/// @param inverseSpeed 1 / |relative|, 0 where it is 0
template <class D, typename T>
HWY_INLINE Lanes3<D> plateForce(D d, const SliceStep<T>& step, const hn::Vec<D>& surface, const Lanes3<D>& relative,
                                const hn::Vec<D>& speed, const hn::Vec<D>& inverseSpeed, const Lanes3<D>& normal) {
  const auto facing = dot(normal, relative);
  const auto drag = hn::Set(d, step.drag - step.edgeDrag - T(2) * step.lift);
  const auto along =
      hn::MulAdd(hn::Mul(drag, hn::Mul(facing, facing)), inverseSpeed, hn::Mul(hn::Set(d, step.edgeDrag), speed));
  const auto across = hn::Mul(hn::Mul(hn::Set(d, T(2) * step.lift), speed), facing);
  const auto push = hn::Neg(surface);
  return multiplyAdd(normal, hn::Mul(push, across), scaled(relative, hn::Mul(push, along)));
}

/// Drag and lift (eqs. 18-20, or kernels::plateForce) [N]. They are limited to the force that stops the vertex relative
/// to the air within `timeStep`, as in kernels::airForce. With w the velocity relative to the air, s = |w|, the unit
/// normal n turned to face w, and q = n.w: drag = -K_D q w. As (n x u) x u = (q/s) u - n for u = w/s, lift = K_L s (s -
/// q)
/// ((q/s^2) w - n).
/// @param timeStep the time for which they act [s]  @param area see areaNormal  @param force of everything else [N]
template <class D, typename T>
HWY_INLINE Lanes3<D> airForce(D d, const SlicedCloth<T>& cloth, const SliceStep<T>& step, T timeStep,
                              const Lanes3<D>& area, int slice, int lane, const Lanes3<D>& force) {
  const int i = slice * sliceLanes + lane;
  const auto zero = hn::Zero(d);
  const Lanes3<D> wind = {hn::Set(d, step.windX), hn::Set(d, step.windY), hn::Set(d, step.windZ)};
  const Lanes3<D> relative = subtract(load3(d, cloth.velocity, i), wind);
  const auto speed = hn::Sqrt(dot(relative, relative));
  const auto size = hn::Sqrt(dot(area, area));
  // One division for both: 1 / |w| = |N| / (|w| |N|).
  const auto product = hn::Mul(speed, size);
  const auto inverse = hn::IfThenElseZero(hn::Gt(product, zero), hn::Div(hn::Set(d, T(1)), product));
  const Lanes3<D> normal = scaled(area, hn::Mul(inverse, speed));
  const auto surface = hn::LoadU(d, cloth.area.data() + i);
  const auto mass = hn::LoadU(d, cloth.mass.data() + i);
  if (step.airModel == AirModel::Plate || (step.airModel == AirModel::Auto && cloth.fabric)) {
    const Lanes3<D> plate = plateForce(d, step, surface, relative, speed, hn::Mul(inverse, size), normal);
    return limitedAirForce(d, plate, timeStep, mass, speed);
  }
  const auto facing = dot(normal, relative);
  const auto q = hn::Abs(facing);
  auto lift = hn::Mul(hn::Mul(surface, hn::Set(d, step.lift)), hn::Sub(speed, q));  // K_L (s - q)
  const auto drag = hn::Mul(hn::Mul(surface, hn::Set(d, step.drag)), q);
  auto side = facing;
  if (step.liftRise > T(0)) {
    // Lift is limited to R q', implicit in the normal velocity q' = p + h/m (f - R q') after the kick. p + h/m f is the
    // normal velocity after the kick by all other forces; its sign tells the side that faces the air.
    const auto push = hn::Div(hn::Set(d, timeStep), mass);
    side = hn::MulAdd(push, hn::NegMulAdd(drag, facing, dot(normal, force)), facing);
    const auto rise = hn::Mul(hn::Mul(surface, hn::Set(d, step.liftRise)), speed);
    const auto full = hn::Mul(lift, speed);
    const auto share = hn::Div(hn::Mul(hn::Abs(side), rise), hn::MulAdd(hn::Mul(push, rise), full, full));
    lift = hn::IfThenElseZero(hn::Gt(full, zero), hn::Mul(lift, hn::Min(share, hn::Set(d, T(1)))));
  }
  const auto along = hn::MulSub(hn::Mul(lift, q), hn::Mul(inverse, size), drag);
  Lanes3<D> air = scaled(relative, along);
  air = multiplyAdd(normal, hn::Neg(hn::Mul(hn::CopySign(lift, side), speed)), air);
  return limitedAirForce(d, air, timeStep, mass, speed);
}

/// Adds drag and lift to `force`.
template <class D, typename T>
HWY_INLINE Lanes3<D> addAir(D d, const SlicedCloth<T>& cloth, const SliceStep<T>& step, const SpringTerms<T>* terms,
                            int slice, int lane, const Lanes3<D>& force) {
  const Lanes3<D> area = areaNormal(d, cloth, terms, slice, lane);
  return add(force, airForce(d, cloth, step, step.timeStep, area, slice, lane, force));
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
