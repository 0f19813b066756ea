// Included once for each instruction set, so it needs this guard.
#if defined(DRAPE_SIM_SIMD_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef DRAPE_SIM_SIMD_LANES_INL_HPP
#undef DRAPE_SIM_SIMD_LANES_INL_HPP
#else
#define DRAPE_SIM_SIMD_LANES_INL_HPP
#endif

#include "sim/simd/sliced_cloth.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many lanes as the machine's registers have, but no more than a slice.
template <typename T>
using LanesOf = hn::CappedTag<T, sliceLanes>;

/// A vector in space for each lane.
template <class D>
struct Lanes3 {
  hn::Vec<D> x, y, z;
};

template <class D>
HWY_INLINE Lanes3<D> add(const Lanes3<D>& a, const Lanes3<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class D>
HWY_INLINE Lanes3<D> subtract(const Lanes3<D>& a, const Lanes3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// a * factor + b, fused.
template <class D>
HWY_INLINE Lanes3<D> multiplyAdd(const Lanes3<D>& a, hn::Vec<D> factor, const Lanes3<D>& b) {
  return {hn::MulAdd(a.x, factor, b.x), hn::MulAdd(a.y, factor, b.y), hn::MulAdd(a.z, factor, b.z)};
}

template <class D>
HWY_INLINE Lanes3<D> scaled(const Lanes3<D>& a, hn::Vec<D> factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

template <class D>
HWY_INLINE hn::Vec<D> dot(const Lanes3<D>& a, const Lanes3<D>& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

/// c + a x b.
template <class D>
HWY_INLINE Lanes3<D> addCross(const Lanes3<D>& a, const Lanes3<D>& b, const Lanes3<D>& c) {
  return {hn::NegMulAdd(a.z, b.y, hn::MulAdd(a.y, b.z, c.x)), hn::NegMulAdd(a.x, b.z, hn::MulAdd(a.z, b.x, c.y)),
          hn::NegMulAdd(a.y, b.x, hn::MulAdd(a.x, b.y, c.z))};
}

/// A symmetric 3x3 matrix for each lane.
template <class D>
struct Symmetric {
  hn::Vec<D> xx, xy, xz, yy, yz, zz;

  static HWY_INLINE Symmetric zero(D d) {
    const auto z = hn::Zero(d);
    return {z, z, z, z, z, z};
  }

  /// += alpha I + beta o o^T.
  HWY_INLINE void add(hn::Vec<D> alpha, hn::Vec<D> beta, const Lanes3<D>& o) {
    const Lanes3<D> bo = scaled(o, beta);
    xx = hn::Add(hn::MulAdd(bo.x, o.x, xx), alpha);
    xy = hn::MulAdd(bo.x, o.y, xy);
    xz = hn::MulAdd(bo.x, o.z, xz);
    yy = hn::Add(hn::MulAdd(bo.y, o.y, yy), alpha);
    yz = hn::MulAdd(bo.y, o.z, yz);
    zz = hn::Add(hn::MulAdd(bo.z, o.z, zz), alpha);
  }

  /// The inverse times `factor`, by cofactors.
  HWY_INLINE Symmetric inverse(hn::Vec<D> factor) const {
    const Lanes3<D> c = cofactors();
    const auto scale = hn::Div(factor, determinant(c));
    return {hn::Mul(scale, c.x),
            hn::Mul(scale, c.y),
            hn::Mul(scale, c.z),
            hn::Mul(scale, hn::NegMulAdd(xz, xz, hn::Mul(xx, zz))),
            hn::Mul(scale, hn::NegMulAdd(xx, yz, hn::Mul(xy, xz))),
            hn::Mul(scale, hn::NegMulAdd(xy, xy, hn::Mul(xx, yy)))};
  }

  /// Of the first row.
  HWY_INLINE Lanes3<D> cofactors() const {
    return {hn::NegMulAdd(yz, yz, hn::Mul(yy, zz)), hn::NegMulAdd(xy, zz, hn::Mul(xz, yz)),
            hn::NegMulAdd(xz, yy, hn::Mul(xy, yz))};
  }

  HWY_INLINE hn::Vec<D> determinant() const { return determinant(cofactors()); }
  HWY_INLINE hn::Vec<D> determinant(const Lanes3<D>& c) const {
    return hn::MulAdd(xz, c.z, hn::MulAdd(xy, c.y, hn::Mul(xx, c.x)));
  }

  /// Frobenius.
  HWY_INLINE hn::Vec<D> squaredNorm() const {
    const auto diagonal = hn::MulAdd(zz, zz, hn::MulAdd(yy, yy, hn::Mul(xx, xx)));
    const auto beside = hn::MulAdd(yz, yz, hn::MulAdd(xz, xz, hn::Mul(xy, xy)));
    return hn::Add(diagonal, hn::Add(beside, beside));
  }

  HWY_INLINE Lanes3<D> times(const Lanes3<D>& v) const {
    return {hn::MulAdd(xz, v.z, hn::MulAdd(xy, v.y, hn::Mul(xx, v.x))),
            hn::MulAdd(yz, v.z, hn::MulAdd(yy, v.y, hn::Mul(xy, v.x))),
            hn::MulAdd(zz, v.z, hn::MulAdd(yz, v.y, hn::Mul(xz, v.x)))};
  }
};

template <class D, typename T>
HWY_INLINE Lanes3<D> load3(D d, const LaneVectors<T>& vectors, std::ptrdiff_t at) {
  return {hn::LoadU(d, vectors.x.data() + at), hn::LoadU(d, vectors.y.data() + at),
          hn::LoadU(d, vectors.z.data() + at)};
}

template <class D, typename T>
HWY_INLINE void store3(D d, const Lanes3<D>& value, LaneVectors<T>& vectors, std::ptrdiff_t at) {
  hn::StoreU(value.x, d, vectors.x.data() + at);
  hn::StoreU(value.y, d, vectors.y.data() + at);
  hn::StoreU(value.z, d, vectors.z.data() + at);
  if constexpr (sizeof(T) == sizeof(float)) {
    if (!vectors.interleaved.empty()) {
      T* const to = vectors.interleaved.data() + 4 * at;
#if HWY_TARGET == HWY_SCALAR
      hn::StoreU(value.x, d, to);
      hn::StoreU(value.y, d, to + 1);
      hn::StoreU(value.z, d, to + 2);
#else
      hn::StoreInterleaved4(value.x, value.y, value.z, value.z, d, to);
#endif
    }
  }
}

template <class D, typename T>
HWY_INLINE Lanes3<D> offsetOf(D d, const SpringTerms<T>& terms, int lane) {
  return {hn::LoadU(d, terms.x.data() + lane), hn::LoadU(d, terms.y.data() + lane),
          hn::LoadU(d, terms.z.data() + lane)};
}

template <class D, typename T>
HWY_INLINE Symmetric<D> loadSymmetric(D d, const SliceMatrices<T>& from, int lane) {
  return {hn::LoadU(d, from[0].data() + lane), hn::LoadU(d, from[1].data() + lane),
          hn::LoadU(d, from[2].data() + lane), hn::LoadU(d, from[3].data() + lane),
          hn::LoadU(d, from[4].data() + lane), hn::LoadU(d, from[5].data() + lane)};
}

template <class D, typename T>
HWY_INLINE void storeSymmetric(D d, const Symmetric<D>& value, SliceMatrices<T>& to, int lane) {
  hn::StoreU(value.xx, d, to[0].data() + lane);
  hn::StoreU(value.xy, d, to[1].data() + lane);
  hn::StoreU(value.xz, d, to[2].data() + lane);
  hn::StoreU(value.yy, d, to[3].data() + lane);
  hn::StoreU(value.yz, d, to[4].data() + lane);
  hn::StoreU(value.zz, d, to[5].data() + lane);
}

/// Three coordinates and a fourth number for each lane.
template <class D>
struct Lanes4 {
  hn::Vec<D> x, y, z, w;
};

#if HWY_TARGET == HWY_SCALAR

template <class D>
HWY_INLINE Lanes4<D> fetch4(D d, const float* interleaved, const std::int32_t* table) {
  const float* const from = interleaved + 4 * static_cast<std::size_t>(*table);
  return {hn::LoadU(d, from), hn::LoadU(d, from + 1), hn::LoadU(d, from + 2), hn::LoadU(d, from + 3)};
}

template <class D>
HWY_INLINE void store4(D d, const Lanes4<D>& value, float* interleaved, const std::int32_t* table) {
  float* const to = interleaved + 4 * static_cast<std::size_t>(*table);
  hn::StoreU(value.x, d, to);
  hn::StoreU(value.y, d, to + 1);
  hn::StoreU(value.z, d, to + 2);
  hn::StoreU(value.w, d, to + 3);
}

#else

/// Blocks of 4 numbers, for every 4th lane, next to each other in one register.
template <class D>
HWY_INLINE hn::Vec<D> loadBlocks(D d, const float* interleaved, const std::int32_t* table) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  if constexpr (lanes == 4) {
    return hn::LoadU(d, interleaved + 4 * static_cast<std::size_t>(table[0]));
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, loadBlocks(half, interleaved, table + lanes / 2), loadBlocks(half, interleaved, table));
  }
}

template <class D>
HWY_INLINE void storeBlocks(D d, hn::Vec<D> blocks, float* interleaved, const std::int32_t* table) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  if constexpr (lanes == 4) {
    hn::StoreU(blocks, d, interleaved + 4 * static_cast<std::size_t>(table[0]));
  } else {
    const hn::Half<D> half;
    storeBlocks(half, hn::LowerHalf(half, blocks), interleaved, table);
    storeBlocks(half, hn::UpperHalf(half, blocks), interleaved, table + lanes / 2);
  }
}

/// Transposes each block of 4 x 4 numbers.
template <class D>
HWY_INLINE Lanes4<D> transposed(D d, const Lanes4<D>& rows) {
  const hn::RepartitionToWide<D> wide;
  const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, rows.x, rows.y));
  const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, rows.z, rows.w));
  const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, rows.x, rows.y));
  const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, rows.z, rows.w));
  return {hn::BitCast(d, hn::InterleaveLower(wide, low01, low23)),
          hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23)),
          hn::BitCast(d, hn::InterleaveLower(wide, high01, high23)),
          hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23))};
}

/// Loads the interleaved numbers at the indices in `table`.
template <class D>
HWY_INLINE Lanes4<D> fetch4(D d, const float* interleaved, const std::int32_t* table) {
  return transposed(d, {loadBlocks(d, interleaved, table), loadBlocks(d, interleaved, table + 1),
                        loadBlocks(d, interleaved, table + 2), loadBlocks(d, interleaved, table + 3)});
}

/// Stores them. No index may occur twice, except that of the dummy vertex.
template <class D>
HWY_INLINE void store4(D d, const Lanes4<D>& value, float* interleaved, const std::int32_t* table) {
  const Lanes4<D> rows = transposed(d, value);
  storeBlocks(d, rows.x, interleaved, table);
  storeBlocks(d, rows.y, interleaved, table + 1);
  storeBlocks(d, rows.z, interleaved, table + 2);
  storeBlocks(d, rows.w, interleaved, table + 3);
}

#endif

/// Indices of lanes for a gather of float or of double.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> loadIndices(D, const std::int32_t* from) {
  const hn::RebindToSigned<D> indices;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    return hn::LoadU(indices, from);
  } else {
    return hn::PromoteTo(indices, hn::LoadU(hn::Rebind<std::int32_t, D>(), from));
  }
}

/// The neighbours of some lanes of a slot.
template <class D>
class Neighbours {
  using T = hn::TFromD<D>;

 public:
  HWY_INLINE Neighbours(const SliceLayout& layout, const SliceLayout::Slot& slot, int lane)
      : Neighbours(slot, layout.neighbourTables, lane) {}

  HWY_INLINE Neighbours(const SliceLayout::Slot& slot, const std::vector<SliceLayout::NeighbourTable>& tables, int lane)
      : consecutive_(slot.table < 0),
        first_(slot.first + lane),
        table_(slot.table < 0 ? nullptr : tables[slot.table].data() + lane) {}

  HWY_INLINE Neighbours(const SliceLayout::NeighbourTable& table, int lane)
      : consecutive_(false), first_(0), table_(table.data() + lane) {}

  HWY_INLINE Lanes3<D> load(const LaneVectors<T>& vectors) const {
    const D d;
    if (HWY_LIKELY(consecutive_)) {
      return load3(d, vectors, first_);
    }
    if constexpr (sizeof(T) == sizeof(float)) {
      if (!vectors.interleaved.empty()) {
        const Lanes4<D> values = fetch4(d, vectors.interleaved.data(), table_);
        return {values.x, values.y, values.z};
      }
    }
    const auto indices = loadIndices(d, table_);
    return {hn::GatherIndex(d, vectors.x.data(), indices), hn::GatherIndex(d, vectors.y.data(), indices),
            hn::GatherIndex(d, vectors.z.data(), indices)};
  }

 private:
  bool consecutive_;
  int first_;
  const std::int32_t* table_;
};

/// The force of a spring on its near end, k (1 - l0/L) times the offset o to its far end, and the derivative with
/// damping h J' = alpha I + beta o o^T (eqs. 13, 15, 16 and other variants; see kernels::springDerivative).
template <class D>
struct SpringLanes {
  hn::Vec<D> elastic;  // [N/m]
  hn::Vec<D> alpha;    // C_d + h a [N s/m]
  hn::Vec<D> beta;     // h b / L^2 [N s/m^3]
};

/// The length of a spring relative to its rest length.
template <class D>
struct Elongation {
  hn::Mask<D> present;   // the lane has a spring
  hn::Mask<D> directed;  // and the spring is long enough to have a direction
  hn::Vec<D> inverse;    // 1 / L [1/m]
  hn::Vec<D> ratio;      // l0 / L [-]
};

template <class D>
HWY_INLINE Elongation<D> elongationOf(D d, const Lanes3<D>& offset, hn::Vec<D> rest) {
  using T = hn::TFromD<D>;
  const auto squared = dot(offset, offset);
  const auto shortest = hn::Mul(rest, hn::Set(d, static_cast<T>(1e-9)));
  const auto length = hn::Sqrt(squared);
  const auto present = hn::Ge(rest, hn::Zero(d));
  const auto directed = hn::And(present, hn::Gt(length, shortest));
  const auto inverse = hn::Div(hn::Set(d, T(1)), length);
  return {present, directed, inverse, hn::Mul(rest, inverse)};
}

/// k (1 - l0/L), zero without a spring or a direction.
template <class D>
HWY_INLINE hn::Vec<D> elasticOf(D d, const Elongation<D>& e, hn::Vec<D> stiffness) {
  const auto one = hn::Set(d, hn::TFromD<D>(1));
  return hn::IfThenElseZero(e.directed, hn::Mul(stiffness, hn::Sub(one, e.ratio)));
}

/// Half of a spring's energy, 1/4 k (L - l0)^2: the part of one end. @param elastic the result of elasticOf
template <class D>
HWY_INLINE hn::Vec<D> halfEnergyOf(D d, const Elongation<D>& e, const Lanes3<D>& offset, hn::Vec<D> rest,
                                   hn::Vec<D> stiffness, hn::Vec<D> elastic) {
  const auto slack = hn::Sub(hn::Set(d, hn::TFromD<D>(1)), e.ratio);
  const auto stretched = hn::Mul(hn::Mul(elastic, slack), dot(offset, offset));
  const auto collapsed = hn::IfThenElseZero(e.present, hn::Mul(stiffness, hn::Mul(rest, rest)));
  return hn::Mul(hn::Set(d, hn::TFromD<D>(0.25)), hn::IfThenElse(e.directed, stretched, collapsed));
}

/// The accelerations of the aggregates of some lanes.
template <class D, typename T>
HWY_INLINE Lanes3<D> aggregateAcceleration(D d, const LaneVectors<T>& accelerations, const std::int32_t* aggregates) {
  const auto indices = loadIndices(d, aggregates);
  return {hn::GatherIndex(d, accelerations.x.data(), indices), hn::GatherIndex(d, accelerations.y.data(), indices),
          hn::GatherIndex(d, accelerations.z.data(), indices)};
}

/// The parameters of all springs in a step, loaded once.
template <class D>
struct SpringConstants {
  hn::Vec<D> stiffness;       // k [N/m]
  hn::Vec<D> timedStiffness;  // h k [N s/m]
  hn::Vec<D> damping;         // C_d [N s/m]
  ForceDerivative derivative;

  template <typename T>
  HWY_INLINE SpringConstants(D d, const SliceStep<T>& step)
      : stiffness(hn::Set(d, step.stiffness)),
        timedStiffness(hn::Set(d, step.timeStep * step.stiffness)),
        damping(hn::Set(d, step.damping)),
        derivative(step.derivative) {}

  /// The same with a relative stiffness for each lane.
  [[nodiscard]] HWY_INLINE SpringConstants times(hn::Vec<D> relative) const {
    SpringConstants own = *this;
    own.stiffness = hn::Mul(stiffness, relative);
    own.timedStiffness = hn::Mul(timedStiffness, relative);
    return own;
  }
};

/// a and b of the derivative k (a I + b d d^T) in the other variants, from l0/L and 1 - l0/L.
template <class D>
HWY_INLINE void otherDerivative(D d, ForceDerivative variant, hn::Vec<D> slack, hn::Vec<D>& a, hn::Vec<D>& b) {
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, hn::TFromD<D>(1));
  if (variant == ForceDerivative::Exact) {
    a = slack;
  } else if (variant == ForceDerivative::Scalar) {
    a = one;
    b = zero;
  } else if (variant == ForceDerivative::Axial) {
    a = zero;
    b = one;
  } else if (variant == ForceDerivative::TensionOnly) {
    b = hn::IfThenElseZero(hn::Ge(slack, zero), b);
  }
}

template <class D>
HWY_INLINE SpringLanes<D> springLanes(D d, const SpringConstants<D>& constants, const Lanes3<D>& offset,
                                      hn::Vec<D> rest) {
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, hn::TFromD<D>(1));
  const Elongation<D> e = elongationOf(d, offset, rest);
  const auto slack = hn::Sub(one, e.ratio);  // negative when compressed
  auto a = hn::Max(slack, zero);             // eq. 16 drops the negative part
  auto b = e.ratio;
  if (HWY_UNLIKELY(constants.derivative != ForceDerivative::Stabilised)) {
    otherDerivative(d, constants.derivative, slack, a, b);
  }
  const auto undirected = constants.derivative == ForceDerivative::TensionOnly ? zero : one;
  a = hn::IfThenElse(e.directed, a, undirected);
  b = hn::IfThenElseZero(e.directed, hn::Mul(b, hn::Mul(e.inverse, e.inverse)));
  return {.elastic = hn::IfThenElseZero(e.directed, hn::Mul(constants.stiffness, slack)),
          .alpha = hn::IfThenElseZero(e.present, hn::MulAdd(constants.timedStiffness, a, constants.damping)),
          .beta = hn::Mul(constants.timedStiffness, b)};
}

template <class D, typename T>
HWY_INLINE void storeOffset(D d, SpringTerms<T>& terms, int lane, const Lanes3<D>& offset) {
  hn::StoreU(offset.x, d, terms.x.data() + lane);
  hn::StoreU(offset.y, d, terms.y.data() + lane);
  hn::StoreU(offset.z, d, terms.z.data() + lane);
}

template <class D, typename T>
HWY_INLINE void storeTerms(D d, SpringTerms<T>& terms, int lane, const Lanes3<D>& offset,
                           const SpringLanes<D>& spring) {
  storeOffset(d, terms, lane, offset);
  hn::StoreU(spring.alpha, d, terms.alpha.data() + lane);
  hn::StoreU(spring.beta, d, terms.beta.data() + lane);
}

/// Adds the attachment's force at the corners of its triangle, and h^2 times its stiffness to the diagonal.
template <class D, typename T>
HWY_INLINE void addAttachment(D d, const SliceStep<T>& step, int slice, int lane, Lanes3<D>& force,
                              hn::Vec<D>& diagonal) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (const auto& corner : step.attachedCorners) {
    if (corner.slice == slice && corner.lane >= lane && corner.lane < lane + lanes) {
      std::array<T, sliceLanes> only{};
      only[corner.lane - lane] = T(1);
      const auto mask = hn::LoadU(d, only.data());
      force = multiplyAdd(Lanes3<D>{hn::Set(d, corner.forceX), hn::Set(d, corner.forceY), hn::Set(d, corner.forceZ)},
                          mask, force);
      diagonal = hn::MulAdd(hn::Set(d, step.timeStep * step.timeStep * corner.stiffness), mask, diagonal);
    }
  }
}

}  // namespace drape::sim::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
