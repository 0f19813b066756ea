// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/exact/pair_distances_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/broad_phase/mesh_lanes.hpp"
#include "sim/contact/closest_features/triangle_geometry.hpp"
#include "sim/contact/exact/pair_distances.hpp"

#include <hwy/highway.h>
#include <algorithm>
#include <limits>

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

/// The closest points of a pair: their offset, from the first feature to the second, their weights, and whether
/// rounding may move them far. The weights are those of the vertices b, c and d; those of edges have the sign of their
/// feature.
struct ClosestPoints {
  Points offset;
  RealLanes b, c, d;
  hn::Mask<Reals> isIllConditioned;
};

/// The point of the segment from `from` along `side` that is closest to the origin.
struct OnSegment {
  RealLanes along;
  Points point;

  HWY_INLINE OnSegment(const Points& from, const Points& side)
      : along(clampToUnit(ratio(hn::Neg(product(from, side)), product(side, side)))),
        point(drape::sim::contact::HWY_NAMESPACE::along(from, along, side)) {}
};

/// Ratios of a squared area to the squared sides below which a triangle is a sliver, and rounding may move closest
/// points far.
constexpr double thin = 1e-10;
constexpr double illConditioned = 1e-6;

/// From the vertex to the triangle.
HWY_INLINE ClosestPoints closestOfTriangle(const Tetrahedra& t) {
  const Reals d;
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0);
  const Points first = minus(t.c, t.b);
  const Points second = minus(t.d, t.b);
  const OnSegment bc(t.b, first);
  const OnSegment bd(t.b, second);
  const OnSegment cd(t.c, minus(t.d, t.c));
  ClosestPoints best{bc.point, hn::Sub(one, bc.along), bc.along, zero, hn::MaskFromVec(zero)};
  RealLanes squared = product(bc.point, bc.point);
  const auto offer = [&](const Points& point, RealLanes b, RealLanes c, RealLanes e) HWY_ATTR {
    const RealLanes its = product(point, point);
    const auto closer = hn::Lt(its, squared);
    best.offset = select(closer, point, best.offset);
    best.b = hn::IfThenElse(closer, b, best.b);
    best.c = hn::IfThenElse(closer, c, best.c);
    best.d = hn::IfThenElse(closer, e, best.d);
    squared = hn::Min(its, squared);
  };
  offer(bd.point, hn::Sub(one, bd.along), zero, bd.along);
  offer(cd.point, zero, hn::Sub(one, cd.along), cd.along);
  const Points normal = normalTo(first, second);
  const RealLanes area = product(normal, normal);
  const RealLanes sides = hn::Mul(product(first, first), product(second, second));
  // The barycentric coordinates of the origin, times the area.
  const RealLanes ofC = product(normalTo(second, t.b), normal);
  const RealLanes ofD = product(normalTo(t.b, first), normal);
  const auto inside = hn::And(hn::And(hn::Ge(ofC, zero), hn::Ge(ofD, zero)),
                              hn::And(hn::Le(hn::Add(ofC, ofD), area), hn::Gt(area, hn::Mul(hn::Set(d, thin), sides))));
  const RealLanes height = ratio(product(normal, t.b), area);
  const Points foot = {hn::Mul(height, normal.x), hn::Mul(height, normal.y), hn::Mul(height, normal.z)};
  const RealLanes c = ratio(ofC, area);
  const RealLanes e = ratio(ofD, area);
  best.offset = select(inside, foot, best.offset);
  best.b = hn::IfThenElse(inside, hn::Sub(hn::Sub(one, c), e), best.b);
  best.c = hn::IfThenElse(inside, c, best.c);
  best.d = hn::IfThenElse(inside, e, best.d);
  best.isIllConditioned = hn::Le(area, hn::Mul(hn::Set(d, illConditioned), sides));
  return best;
}

/// From the first edge to the second. As in nearestOfSegments.
HWY_INLINE ClosestPoints closestOfEdges(const Tetrahedra& t) {
  const Reals d;
  const Points& one = t.b;
  const Points two = minus(t.d, t.c);
  const RealLanes a = product(one, one);
  const RealLanes e = product(two, two);
  const RealLanes b = product(one, two);
  const RealLanes squares = hn::Mul(a, e);
  const RealLanes determinant = hn::NegMulAdd(b, b, squares);
  const auto apart = hn::Gt(determinant, hn::Mul(hn::Set(d, 1e-14), squares));
  const RealLanes numerator = hn::Sub(hn::Mul(e, product(one, t.c)), hn::Mul(b, product(two, t.c)));
  RealLanes first = hn::IfThenElseZero(apart, clampToUnit(ratio(numerator, determinant)));
  const Points onFirst = {hn::Mul(first, one.x), hn::Mul(first, one.y), hn::Mul(first, one.z)};
  const RealLanes second = clampToUnit(ratio(product(minus(onFirst, t.c), two), e));
  const Points onSecond = along(t.c, second, two);
  first = clampToUnit(ratio(product(onSecond, one), a));
  return {along(onSecond, hn::Neg(first), one), hn::Neg(first), hn::Sub(hn::Set(d, 1.0), second), second,
          hn::Le(determinant, hn::Mul(hn::Set(d, illConditioned), squares))};
}

template <bool edges>
HWY_INLINE ClosestPoints closestOf(const Tetrahedra& t) {
  if constexpr (edges) {
    return closestOfEdges(t);
  } else {
    return closestOfTriangle(t);
  }
}

/// How far the second feature lies beyond the first along a unit vector times `length`.
template <bool edges>
HWY_INLINE RealLanes separationOf(const Tetrahedra& t, const Points& vector, RealLanes length) {
  const auto zero = hn::Zero(Reals());
  const RealLanes b = product(t.b, vector);
  const RealLanes c = product(t.c, vector);
  const RealLanes e = product(t.d, vector);
  const RealLanes high = edges ? hn::Max(zero, b) : zero;
  const RealLanes low = edges ? hn::Min(c, e) : hn::Min(b, hn::Min(c, e));
  return ratio(hn::Sub(low, high), length);
}

template <bool edges>
void distancesOf(const PairLanes& pairs, const Vec3* positions, double* distances) {
  const Reals d;
  for (std::size_t i = 0; i < pairs.size(); i += hn::Lanes(d)) {
    const Tetrahedra at(pairs, positions, i);
    const Points offset = closestOf<edges>(at).offset;
    hn::StoreU(separationOf<edges>(at, offset, hn::Sqrt(product(offset, offset))), d, distances + i);
  }
}

template <bool edges>
void approachOf(const PairLanes& pairs, const Vec3* start, const Vec3* end, double* atStart, double* atEnd) {
  const Reals d;
  for (std::size_t i = 0; i < pairs.size(); i += hn::Lanes(d)) {
    const Tetrahedra before(pairs, start, i);
    // The offset leads from the first feature to the second.
    const Points offset = closestOf<edges>(before).offset;
    const RealLanes length = hn::Sqrt(product(offset, offset));
    hn::StoreU(separationOf<edges>(before, offset, length), d, atStart + i);
    hn::StoreU(separationOf<edges>(Tetrahedra(pairs, end, i), offset, length), d, atEnd + i);
  }
}

/// Which points of an edge are certainly ends (isInside).
HWY_INLINE hn::Mask<Reals> areEnds(RealLanes along) {
  const Reals d;
  constexpr double end = 0.9 * insideMargin;
  return hn::Or(hn::Lt(along, hn::Set(d, end)), hn::Gt(along, hn::Set(d, 1.0 - end)));
}

template <bool edges>
void contactGapsOf(const PairLanes& pairs, const Vec3* start, const Vec3* end, double* gaps) {
  const Reals d;
  for (std::size_t i = 0; i < pairs.size(); i += hn::Lanes(d)) {
    const ClosestPoints closest = closestOf<edges>(Tetrahedra(pairs, start, i));
    const Tetrahedra after(pairs, end, i);
    const Points offset =
        along({hn::Mul(closest.b, after.b.x), hn::Mul(closest.b, after.b.y), hn::Mul(closest.b, after.b.z)}, closest.c,
              after.c);
    const RealLanes distance = hn::Sqrt(product(closest.offset, closest.offset));
    const RealLanes predicted = ratio(product(along(offset, closest.d, after.d), closest.offset), distance);
    RealLanes gap = hn::Min(distance, predicted);
    if constexpr (edges) {
      const auto none = hn::Or(areEnds(hn::Neg(closest.b)), areEnds(closest.d));
      gap = hn::IfThenElse(none, hn::Set(d, std::numeric_limits<double>::infinity()), gap);
    }
    hn::StoreU(hn::IfThenZeroElse(closest.isIllConditioned, gap), d, gaps + i);
  }
}

void contactGaps(bool edges, const PairLanes& pairs, const Vec3* start, const Vec3* end, double* gaps) {
  (edges ? contactGapsOf<true> : contactGapsOf<false>)(pairs, start, end, gaps);
}

void distances(bool edges, const PairLanes& pairs, const Vec3* positions, double* result) {
  (edges ? distancesOf<true> : distancesOf<false>)(pairs, positions, result);
}

void approach(bool edges, const PairLanes& pairs, const Vec3* start, const Vec3* end, double* atStart, double* atEnd) {
  (edges ? approachOf<true> : approachOf<false>)(pairs, start, end, atStart, atEnd);
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(distances);
HWY_EXPORT(approach);
HWY_EXPORT(contactGaps);

void PairLanes::pad() {
  for (std::vector<std::int32_t>& part : vertices_) {
    part.resize(std::max(part.size(), size_ + maxDoubles));
    std::fill_n(part.begin() + static_cast<std::ptrdiff_t>(size_), maxDoubles, 0);
  }
}

void measureDistances(bool edges, PairLanes& pairs, const Vec3* positions, std::vector<double>& result) {
  pairs.pad();
  result.resize(pairs.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(distances)(edges, pairs, positions, result.data());
}

void measureApproach(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, Approach& result) {
  pairs.pad();
  result.start.resize(pairs.size() + maxDoubles);
  result.end.resize(pairs.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(approach)(edges, pairs, start, end, result.start.data(), result.end.data());
}

void measureContactGaps(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, std::vector<double>& gaps) {
  pairs.pad();
  gaps.resize(pairs.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(contactGaps)(edges, pairs, start, end, gaps.data());
}

}  // namespace drape::sim::contact
#endif
