// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/exact/pair_distances_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/broad_phase/mesh_lanes.hpp"
#include "sim/contact/exact/pair_distances.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Reals = hn::CappedTag<double, maxDoubles>;
using RealLanes = hn::Vec<Reals>;

/// A vector of points, one vector per coordinate.
struct Points {
  RealLanes x, y, z;
};

HWY_INLINE Points minus(const Points& a, const Points& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE RealLanes product(const Points& a, const Points& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

/// a + factor b
HWY_INLINE Points along(const Points& a, RealLanes factor, const Points& b) {
  return {hn::MulAdd(factor, b.x, a.x), hn::MulAdd(factor, b.y, a.y), hn::MulAdd(factor, b.z, a.z)};
}

HWY_INLINE Points normalTo(const Points& a, const Points& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

HWY_INLINE Points select(hn::Mask<Reals> mask, const Points& yes, const Points& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Points gather(const Vec3* positions, const std::int32_t* vertices) {
  const Reals d;
  const hn::RebindToSigned<Reals> di;
  const auto vertex = hn::PromoteTo(di, hn::LoadU(hn::Rebind<std::int32_t, Reals>(), vertices));
  const auto at = hn::Add(hn::Add(vertex, vertex), vertex);
  const double* from = positions->data();
  return {hn::GatherIndex(d, from, at), hn::GatherIndex(d, from + 1, at), hn::GatherIndex(d, from + 2, at)};
}

/// The vertices of a vector of pairs, relative to the first one of each pair.
struct Tetrahedra {
  Points b, c, d;

  HWY_INLINE Tetrahedra(const PairLanes& pairs, const Vec3* positions, std::size_t i) {
    const Points a = gather(positions, pairs.vertices(0) + i);
    b = minus(gather(positions, pairs.vertices(1) + i), a);
    c = minus(gather(positions, pairs.vertices(2) + i), a);
    d = minus(gather(positions, pairs.vertices(3) + i), a);
  }
};

HWY_INLINE RealLanes clampToUnit(RealLanes value) {
  const Reals d;
  return hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1.0));
}

/// numerator / denominator where that is positive, else 0.
HWY_INLINE RealLanes ratio(RealLanes numerator, RealLanes denominator) {
  const Reals d;
  const auto positive = hn::Gt(denominator, hn::Zero(d));
  return hn::IfThenElseZero(positive, hn::Div(numerator, hn::IfThenElse(positive, denominator, hn::Set(d, 1.0))));
}

/// The point of the segment from `from` along `side` that is closest to the origin.
HWY_INLINE Points nearestToOrigin(const Points& from, const Points& side) {
  return along(from, clampToUnit(ratio(hn::Neg(product(from, side)), product(side, side))), side);
}

/// The offset between the closest points: from the vertex to the triangle.
HWY_INLINE Points offsetToTriangle(const Tetrahedra& t) {
  const Reals d;
  const Points first = minus(t.c, t.b);
  const Points second = minus(t.d, t.b);
  Points best = nearestToOrigin(t.b, first);
  RealLanes squared = product(best, best);
  for (const Points& other : {nearestToOrigin(t.b, second), nearestToOrigin(t.c, minus(t.d, t.c))}) {
    const RealLanes its = product(other, other);
    best = select(hn::Lt(its, squared), other, best);
    squared = hn::Min(its, squared);
  }
  const Points normal = normalTo(first, second);
  const RealLanes area = product(normal, normal);
  // The barycentric coordinates of the origin, times the area.
  const RealLanes ofC = product(normalTo(second, t.b), normal);
  const RealLanes ofD = product(normalTo(t.b, first), normal);
  const auto zero = hn::Zero(d);
  const auto thin = hn::Mul(hn::Set(d, 1e-14), hn::Mul(product(first, first), product(second, second)));
  const auto inside = hn::And(hn::And(hn::Ge(ofC, zero), hn::Ge(ofD, zero)),
                              hn::And(hn::Le(hn::Add(ofC, ofD), area), hn::Gt(area, thin)));
  const RealLanes height = ratio(product(normal, t.b), area);
  return select(inside, {hn::Mul(height, normal.x), hn::Mul(height, normal.y), hn::Mul(height, normal.z)}, best);
}

/// The offset between the closest points: from the first edge to the second. As in nearestOfSegments.
HWY_INLINE Points offsetOfEdges(const Tetrahedra& t) {
  const Reals d;
  const Points& one = t.b;
  const Points two = minus(t.d, t.c);
  const RealLanes a = product(one, one);
  const RealLanes e = product(two, two);
  const RealLanes b = product(one, two);
  const RealLanes determinant = hn::NegMulAdd(b, b, hn::Mul(a, e));
  const auto apart = hn::Gt(determinant, hn::Mul(hn::Set(d, 1e-14), hn::Mul(a, e)));
  const RealLanes numerator = hn::Sub(hn::Mul(e, product(one, t.c)), hn::Mul(b, product(two, t.c)));
  RealLanes first = hn::IfThenElseZero(apart, clampToUnit(ratio(numerator, determinant)));
  const Points onFirst = {hn::Mul(first, one.x), hn::Mul(first, one.y), hn::Mul(first, one.z)};
  const RealLanes second = clampToUnit(ratio(product(minus(onFirst, t.c), two), e));
  const Points onSecond = along(t.c, second, two);
  first = clampToUnit(ratio(product(onSecond, one), a));
  return along(onSecond, hn::Neg(first), one);
}

template <bool edges>
HWY_INLINE Points offsetOf(const Tetrahedra& t) {
  if constexpr (edges) {
    return offsetOfEdges(t);
  } else {
    return offsetToTriangle(t);
  }
}

template <bool edges>
void distancesOf(const PairLanes& pairs, const Vec3* positions, double* distances) {
  const Reals d;
  for (std::size_t i = 0; i < pairs.size(); i += hn::Lanes(d)) {
    const Points offset = offsetOf<edges>(Tetrahedra(pairs, positions, i));
    hn::StoreU(hn::Sqrt(product(offset, offset)), d, distances + i);
  }
}

template <bool edges>
void approachOf(const PairLanes& pairs, const Vec3* start, const Vec3* end, double* distances, double* separations) {
  const Reals d;
  for (std::size_t i = 0; i < pairs.size(); i += hn::Lanes(d)) {
    const Points offset = offsetOf<edges>(Tetrahedra(pairs, start, i));
    const RealLanes distance = hn::Sqrt(product(offset, offset));
    // The offset leads from the first feature to the second.
    const Tetrahedra after(pairs, end, i);
    const RealLanes b = product(after.b, offset);
    const RealLanes c = product(after.c, offset);
    const RealLanes e = product(after.d, offset);
    const RealLanes high = edges ? hn::Max(hn::Zero(d), b) : hn::Zero(d);
    const RealLanes low = edges ? hn::Min(c, e) : hn::Min(b, hn::Min(c, e));
    hn::StoreU(distance, d, distances + i);
    hn::StoreU(ratio(hn::Sub(low, high), distance), d, separations + i);
  }
}

void distances(bool edges, const PairLanes& pairs, const Vec3* positions, double* result) {
  (edges ? distancesOf<true> : distancesOf<false>)(pairs, positions, result);
}

void approach(bool edges, const PairLanes& pairs, const Vec3* start, const Vec3* end, double* distances,
              double* separations) {
  (edges ? approachOf<true> : approachOf<false>)(pairs, start, end, distances, separations);
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(distances);
HWY_EXPORT(approach);

void PairLanes::pad() {
  for (std::vector<std::int32_t>& part : vertices_) {
    part.resize(size_ + maxDoubles, 0);
  }
}

void measureDistances(bool edges, PairLanes& pairs, const Vec3* positions, std::vector<double>& result) {
  pairs.pad();
  result.resize(pairs.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(distances)(edges, pairs, positions, result.data());
}

void measureApproach(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, Approach& result) {
  pairs.pad();
  result.distance.resize(pairs.size() + maxDoubles);
  result.separation.resize(pairs.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(approach)(edges, pairs, start, end, result.distance.data(), result.separation.data());
}

}  // namespace drape::sim::contact
#endif
