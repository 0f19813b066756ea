// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/self/search_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/self/float_lanes.hpp"
#include "sim/contact/self/point_hash.hpp"

#include <hwy/highway.h>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, maxLanes>;
using Numbers = hn::Rebind<std::int32_t, Floats>;
using FloatLanes = hn::Vec<Floats>;
using FloatMask = hn::Mask<Floats>;

struct Lanes {
  FloatLanes x, y, z;
};

HWY_INLINE Lanes load(const PositionLanes& positions, int at) {
  const Floats d;
  return {hn::LoadU(d, positions.x.data() + at), hn::LoadU(d, positions.y.data() + at),
          hn::LoadU(d, positions.z.data() + at)};
}

HWY_INLINE Lanes gather(const PositionLanes& positions, const std::int32_t* indices) {
  const Floats d;
  const auto at = hn::LoadU(Numbers(), indices);
  return {hn::GatherIndex(d, positions.x.data(), at), hn::GatherIndex(d, positions.y.data(), at),
          hn::GatherIndex(d, positions.z.data(), at)};
}

HWY_INLINE Lanes subtract(const Lanes& a, const Lanes& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE FloatLanes dot(const Lanes& a, const Lanes& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

HWY_INLINE Lanes cross(const Lanes& a, const Lanes& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

/// The lanes of a mask as bits.
HWY_INLINE std::uint32_t bitsOf(FloatMask mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(Floats(), mask, bytes.data());
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

HWY_INLINE FloatMask firstLanes(int count) {
  const Floats d;
  return hn::FirstN(d, static_cast<std::size_t>(std::max(0, count)));
}

/// Running minimum and maximum of each coordinate.
class BoxLanes {
 public:
  BoxLanes() : low_(splat(LaneBox().low[0])), high_(splat(LaneBox().high[0])) {}

  HWY_INLINE void take(const Lanes& value) {
    low_ = {hn::Min(low_.x, value.x), hn::Min(low_.y, value.y), hn::Min(low_.z, value.z)};
    high_ = {hn::Max(high_.x, value.x), hn::Max(high_.y, value.y), hn::Max(high_.z, value.z)};
  }

  HWY_INLINE void take(const Lanes& value, FloatMask present) {
    const Floats d;
    const auto low = hn::Set(d, LaneBox().low[0]);
    const auto high = hn::Set(d, LaneBox().high[0]);
    low_ = {hn::Min(low_.x, hn::IfThenElse(present, value.x, low)),
            hn::Min(low_.y, hn::IfThenElse(present, value.y, low)),
            hn::Min(low_.z, hn::IfThenElse(present, value.z, low))};
    high_ = {hn::Max(high_.x, hn::IfThenElse(present, value.x, high)),
             hn::Max(high_.y, hn::IfThenElse(present, value.y, high)),
             hn::Max(high_.z, hn::IfThenElse(present, value.z, high))};
  }

  [[nodiscard]] LaneBox box() const {
    const Floats d;
    return {{hn::GetLane(hn::MinOfLanes(d, low_.x)), hn::GetLane(hn::MinOfLanes(d, low_.y)),
             hn::GetLane(hn::MinOfLanes(d, low_.z))},
            {hn::GetLane(hn::MaxOfLanes(d, high_.x)), hn::GetLane(hn::MaxOfLanes(d, high_.y)),
             hn::GetLane(hn::MaxOfLanes(d, high_.z))}};
  }

 private:
  static HWY_INLINE Lanes splat(float value) {
    const Floats d;
    return {hn::Set(d, value), hn::Set(d, value), hn::Set(d, value)};
  }

  Lanes low_, high_;
};

LaneBox displacements(const PositionLanes& positions, const PositionLanes& since, int count) {
  const int lanes = static_cast<int>(hn::Lanes(Floats()));
  BoxLanes box;
  for (int i = 0; i < count; i += lanes) {
    box.take(subtract(load(positions, i), load(since, i)), firstLanes(count - i));
  }
  return box.box();
}

LaneBox boxAround(const PositionLanes& positions, int begin, int end) {
  const int lanes = static_cast<int>(hn::Lanes(Floats()));
  BoxLanes box;
  for (int i = begin; i < end; i += lanes) {
    box.take(load(positions, i), firstLanes(end - i));
  }
  return box.box();
}

void select(const PositionLanes& positions, int begin, int end, const LaneBox& box, std::int32_t* inside, int& count) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto within = [&](FloatLanes value, std::size_t axis) {
    return hn::And(hn::Ge(value, hn::Set(d, box.low[axis])), hn::Le(value, hn::Set(d, box.high[axis])));
  };
  for (int i = begin; i < end; i += lanes) {
    const Lanes at = load(positions, i);
    const auto mask = hn::And(hn::And(within(at.x, 0), within(at.y, 1)), hn::And(within(at.z, 2), firstLanes(end - i)));
    const auto indices = hn::Iota(Numbers(), static_cast<std::int32_t>(i));
    count += static_cast<int>(hn::CompressStore(indices, hn::RebindMask(Numbers(), mask), Numbers(), inside + count));
  }
}

bool within(const PositionLanes& positions, const CornerLanes& corners, int begin, int end,
            const std::array<float, 3>& axis, float minSquaredCosine) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Lanes direction = {hn::Set(d, axis[0]), hn::Set(d, axis[1]), hn::Set(d, axis[2])};
  const auto minimum = hn::Set(d, minSquaredCosine);
  for (int i = begin; i < end; i += lanes) {
    const Lanes a = gather(positions, corners.a.data() + i);
    const Lanes n = cross(subtract(gather(positions, corners.b.data() + i), a),
                          subtract(gather(positions, corners.c.data() + i), a));
    const auto along = dot(n, direction);
    const auto good = hn::And(hn::Gt(along, hn::Zero(d)), hn::Ge(hn::Mul(along, along), hn::Mul(minimum, dot(n, n))));
    if (!hn::AllTrue(d, good)) {
      return false;
    }
  }
  return true;
}

void normals(const PositionLanes& positions, const CornerLanes& corners, int count, PositionLanes& result) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const Lanes a = gather(positions, corners.a.data() + i);
    const Lanes n = cross(subtract(gather(positions, corners.b.data() + i), a),
                          subtract(gather(positions, corners.c.data() + i), a));
    hn::StoreU(n.x, d, result.x.data() + i);
    hn::StoreU(n.y, d, result.y.data() + i);
    hn::StoreU(n.z, d, result.z.data() + i);
  }
}

/// (b - a) x (c - a) in the plane.
HWY_INLINE FloatLanes turn(FloatLanes ax, FloatLanes ay, FloatLanes bx, FloatLanes by, FloatLanes cx, FloatLanes cy) {
  return hn::NegMulAdd(hn::Sub(by, ay), hn::Sub(cx, ax), hn::Mul(hn::Sub(bx, ax), hn::Sub(cy, ay)));
}

/// Whether two points lie on the same side of a line and farther from it than a margin.
/// @param first, second the products of their distances with a length  @param limit product of the margin with at least
/// that length [m^2]
HWY_INLINE FloatMask onSameSide(FloatLanes first, FloatLanes second, FloatLanes limit) {
  const auto above = hn::And(hn::Gt(first, limit), hn::Gt(second, limit));
  const auto below = hn::And(hn::Lt(first, hn::Neg(limit)), hn::Lt(second, hn::Neg(limit)));
  return hn::Or(above, below);
}

/// Which of the sides from corner j on touch the side from a to b: the ends of each lie on different sides of the
/// other's line, or within the margin of it, and their bounding boxes intersect.
HWY_INLINE FloatMask touching(const std::array<FloatLanes, 4>& side, const float* x, const float* y, int j,
                              FloatLanes margin) {
  const Floats d;
  const auto& [ax, ay, bx, by] = side;
  const auto cx = hn::LoadU(d, x + j);
  const auto cy = hn::LoadU(d, y + j);
  const auto ex = hn::LoadU(d, x + j + 1);
  const auto ey = hn::LoadU(d, y + j + 1);
  const auto limitOf = [&](FloatLanes dx, FloatLanes dy) { return hn::Mul(margin, hn::Add(hn::Abs(dx), hn::Abs(dy))); };
  const auto apart =
      onSameSide(turn(ax, ay, bx, by, cx, cy), turn(ax, ay, bx, by, ex, ey), limitOf(hn::Sub(bx, ax), hn::Sub(by, ay)));
  const auto apartToo =
      onSameSide(turn(cx, cy, ex, ey, ax, ay), turn(cx, cy, ex, ey, bx, by), limitOf(hn::Sub(ex, cx), hn::Sub(ey, cy)));
  const auto overlap = [&](FloatLanes c, FloatLanes e, FloatLanes a, FloatLanes b) {
    return hn::And(hn::Le(hn::Sub(hn::Min(c, e), margin), hn::Max(a, b)),
                   hn::Ge(hn::Add(hn::Max(c, e), margin), hn::Min(a, b)));
  };
  const auto boxes = hn::And(overlap(cx, ex, ax, bx), overlap(cy, ey, ay, by));
  return hn::AndNot(hn::Or(apart, apartToo), boxes);
}

bool isSimple(const float* x, const float* y, int corners, float margin) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i + 2 < corners; ++i) {
    const std::array<FloatLanes, 4> side = {hn::Set(d, x[i]), hn::Set(d, y[i]), hn::Set(d, x[i + 1]),
                                            hn::Set(d, y[i + 1])};
    const int end = i == 0 ? corners - 1 : corners;  // the last side is adjacent to the first
    for (int j = i + 2; j < end; j += lanes) {
      if (!hn::AllFalse(d, hn::And(touching(side, x, y, j, hn::Set(d, margin)), firstLanes(end - j)))) {
        return false;
      }
    }
  }
  return true;
}

void hash(const PositionLanes& positions, int count, const HashGrid& grid, std::int32_t* buckets) {
  const Floats d;
  const Numbers di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto index = [&](FloatLanes position, std::size_t axis) {
    const auto cell =
        hn::Floor(hn::Mul(hn::Sub(position, hn::Set(d, grid.origin[axis])), hn::Set(d, grid.inverseSize)));
    return hn::And(hn::ConvertTo(di, cell), hn::Set(di, (1 << grid.bits[axis]) - 1));
  };
  for (int i = 0; i < count; i += lanes) {
    const Lanes at = load(positions, i);
    const auto xy = hn::Or(index(at.x, 0), hn::ShiftLeftSame(index(at.y, 1), grid.bits[0]));
    hn::StoreU(hn::Or(xy, hn::ShiftLeftSame(index(at.z, 2), grid.bits[0] + grid.bits[1])), di, buckets + i);
  }
}

/// The range of sorted points that one point is compared with.
struct Run {
  int begin = 0;
  int end = 0;
};

void pairsOfPoint(const SortedPoints& sorted, int i, Run run, float squaredReach, bool skipSameOtherBucket,
                  std::vector<VertexPair>& pairs) {
  const Floats d;
  const Numbers di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const SurfacePoints& points = sorted.points;
  const auto at = static_cast<std::size_t>(i);
  const Lanes here = {hn::Set(d, points.positions.x[at]), hn::Set(d, points.positions.y[at]),
                      hn::Set(d, points.positions.z[at])};
  const auto other = hn::Set(di, sorted.other[at]);
  for (int j = run.begin; j < run.end; j += lanes) {
    const Lanes offset = subtract(load(points.positions, j), here);
    auto near = hn::And(hn::Lt(dot(offset, offset), hn::Set(d, squaredReach)), firstLanes(run.end - j));
    if (skipSameOtherBucket) {
      near = hn::AndNot(hn::RebindMask(d, hn::Eq(hn::LoadU(di, sorted.other.data() + j), other)), near);
    }
    if (hn::AllFalse(d, near)) {
      continue;
    }
    for (std::uint32_t bits = bitsOf(near); bits != 0; bits &= bits - 1) {
      const int a = points.vertex[at];
      const int b = points.vertex[j + std::countr_zero(bits)];
      pairs.push_back(a < b ? VertexPair{a, b} : VertexPair{b, a});
    }
  }
}

void pairs(const SortedPoints& sorted, float squaredReach, bool skipSameOtherBucket, std::vector<VertexPair>& found) {
  const SurfacePoints& points = sorted.points;
  int end = 0;
  for (int begin = 0; begin < points.count; begin = end) {
    end = sorted.begin[static_cast<std::size_t>(sorted.bucket[begin]) + 1];
    const std::int32_t last = points.patch[end - 1];
    int nextRun = begin;
    for (int i = begin; points.patch[i] != last; ++i) {
      while (points.patch[nextRun] == points.patch[i]) {
        ++nextRun;
      }
      pairsOfPoint(sorted, i, {nextRun, end}, squaredReach, skipSameOtherBucket, found);
    }
  }
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(displacements);
HWY_EXPORT(boxAround);
HWY_EXPORT(select);
HWY_EXPORT(within);
HWY_EXPORT(normals);
HWY_EXPORT(isSimple);
HWY_EXPORT(hash);
HWY_EXPORT(pairs);

LaneBox displacementsBetween(const PositionLanes& positions, const PositionLanes& since, int count) {
  return HWY_DYNAMIC_DISPATCH(displacements)(positions, since, count);
}

LaneBox boxOf(const PositionLanes& positions, int begin, int end) {
  return HWY_DYNAMIC_DISPATCH(boxAround)(positions, begin, end);
}

void positionsInside(const PositionLanes& positions, int begin, int end, const LaneBox& box, std::int32_t* inside,
                     int& count) {
  HWY_DYNAMIC_DISPATCH(select)(positions, begin, end, box, inside, count);
}

bool normalsWithin(const PositionLanes& positions, const CornerLanes& corners, int begin, int end,
                   const std::array<float, 3>& axis, float minSquaredCosine) {
  return HWY_DYNAMIC_DISPATCH(within)(positions, corners, begin, end, axis, minSquaredCosine);
}

void normalsOf(const PositionLanes& positions, const CornerLanes& corners, int count, PositionLanes& result) {
  HWY_DYNAMIC_DISPATCH(normals)(positions, corners, count, result);
}

bool isSimplePolygon(const float* x, const float* y, int corners, float margin) {
  return HWY_DYNAMIC_DISPATCH(isSimple)(x, y, corners, margin);
}

void bucketsOf(const PositionLanes& positions, int count, const HashGrid& grid, std::int32_t* buckets) {
  HWY_DYNAMIC_DISPATCH(hash)(positions, count, grid, buckets);
}

void pairsWithinBuckets(const SortedPoints& sorted, float squaredReach, bool skipSameOtherBucket,
                        std::vector<VertexPair>& found) {
  HWY_DYNAMIC_DISPATCH(pairs)(sorted, squaredReach, skipSameOtherBucket, found);
}

}  // namespace drape::sim::contact
#endif
