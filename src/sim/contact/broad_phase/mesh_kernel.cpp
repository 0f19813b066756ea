// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/broad_phase/mesh_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/broad_phase/mesh_lanes.hpp"

#include <hwy/highway.h>
#include <algorithm>
#include <array>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, maxDoubles>;
using DoubleLanes = hn::Vec<Doubles>;

/// The lanes of a mask as bits.
HWY_INLINE std::uint32_t bitsOf(hn::Mask<Doubles> mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(Doubles(), mask, bytes.data());
  return bytes[0];
}

std::size_t meeting(const BoxList& boxes, const Eigen::AlignedBox3d& box, std::int32_t* met) {
  const Doubles d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); i += lanes) {
    auto meets = hn::FirstN(d, boxes.size() - i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      meets = hn::And(meets, hn::Le(hn::LoadU(d, boxes.low(axis) + i), hn::Set(d, box.max()[at])));
      meets = hn::And(meets, hn::Ge(hn::LoadU(d, boxes.high(axis) + i), hn::Set(d, box.min()[at])));
    }
    for (std::uint32_t bits = bitsOf(meets); bits != 0; bits &= bits - 1) {
      met[count++] = static_cast<std::int32_t>(i) + static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
    }
  }
  return count;
}

void distancesToList(const BoxList& boxes, const Vec3& point, double* squared) {
  const Doubles d;
  for (std::size_t i = 0; i < boxes.size(); i += hn::Lanes(d)) {
    auto sum = hn::Zero(d);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = hn::Set(d, point[static_cast<Eigen::Index>(axis)]);
      const auto below = hn::Sub(hn::LoadU(d, boxes.low(axis) + i), at);
      const auto above = hn::Sub(at, hn::LoadU(d, boxes.high(axis) + i));
      const auto outside = hn::Max(hn::Max(below, above), hn::Zero(d));
      sum = hn::Add(sum, hn::Mul(outside, outside));
    }
    hn::StoreU(sum, d, squared + i);
  }
}

void distances(const TriangleBoxes* boxes, const std::int32_t* leaves, std::size_t count, const Vec3& point,
               double* squared) {
  const hn::CappedTag<double, trianglesPerLeaf> d;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t k = 0; k < count; ++k) {
    const TriangleBoxes& box = boxes[leaves[k]];
    for (std::size_t i = 0; i < trianglesPerLeaf; i += lanes) {
      auto sum = hn::Zero(d);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = hn::Set(d, point[static_cast<Eigen::Index>(axis)]);
        const auto below = hn::Sub(hn::LoadU(d, box.low[axis].data() + i), at);
        const auto above = hn::Sub(at, hn::LoadU(d, box.high[axis].data() + i));
        const auto outside = hn::Max(hn::Max(below, above), hn::Zero(d));
        sum = hn::Add(sum, hn::Mul(outside, outside));
      }
      hn::StoreU(sum, d, squared + trianglesPerLeaf * k + i);
    }
  }
}

Extent extents(const LeafLanes& lanes, const std::size_t* begin, const std::int32_t* leaves, std::size_t count,
               const Vec3& direction, Extent* result) {
  const Doubles d;
  const std::size_t step = hn::Lanes(d);
  const auto x = hn::Set(d, direction.x());
  const auto y = hn::Set(d, direction.y());
  const auto z = hn::Set(d, direction.z());
  Extent all;
  for (std::size_t k = 0; k < count; ++k) {
    auto low = hn::Set(d, Extent().low);
    auto high = hn::Set(d, Extent().high);
    for (std::size_t i = begin[leaves[k]]; i < begin[leaves[k] + 1]; i += step) {
      const auto inPlane =
          hn::Add(hn::Mul(x, hn::LoadU(d, lanes.x.data() + i)), hn::Mul(y, hn::LoadU(d, lanes.y.data() + i)));
      const auto along = hn::Add(inPlane, hn::Mul(z, hn::LoadU(d, lanes.z.data() + i)));
      low = hn::Min(low, along);
      high = hn::Max(high, along);
    }
    result[k] = {hn::GetLane(hn::MinOfLanes(d, low)), hn::GetLane(hn::MaxOfLanes(d, high))};
    all = {std::min(all.low, result[k].low), std::max(all.high, result[k].high)};
  }
  return all;
}

SupportIndex support(const LeafLanes& lanes, const std::size_t* begin, const std::int32_t* leaves, std::size_t count,
                     const Vec3& direction) {
  const Doubles d;
  const std::size_t step = hn::Lanes(d);
  const auto x = hn::Set(d, direction.x());
  const auto y = hn::Set(d, direction.y());
  const auto z = hn::Set(d, direction.z());
  auto high = hn::Set(d, SupportIndex().height);
  auto where = hn::Zero(d);  // indices as doubles, which hold them exactly
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = begin[leaves[k]]; i < begin[leaves[k] + 1]; i += step) {
      const auto inPlane =
          hn::Add(hn::Mul(x, hn::LoadU(d, lanes.x.data() + i)), hn::Mul(y, hn::LoadU(d, lanes.y.data() + i)));
      const auto along = hn::Add(inPlane, hn::Mul(z, hn::LoadU(d, lanes.z.data() + i)));
      where = hn::IfThenElse(hn::Gt(along, high), hn::Iota(d, static_cast<double>(i)), where);
      high = hn::Max(high, along);
    }
  }
  const auto maximum = hn::MaxOfLanes(d, high);
  const auto first = hn::IfThenElse(hn::Eq(high, maximum), where, hn::Set(d, std::numeric_limits<double>::infinity()));
  const double at = hn::GetLane(hn::MinOfLanes(d, first));
  // Along NaN there is no maximum.
  return {hn::GetLane(maximum),
          at < std::numeric_limits<double>::infinity() ? static_cast<std::size_t>(at) : begin[leaves[0]]};
}

/// A vector of points, one vector per coordinate.
struct PointLanes {
  DoubleLanes x, y, z;

  HWY_INLINE DoubleLanes along(const Vec3& direction) const {
    const Doubles d;
    const auto inPlane = hn::Add(hn::Mul(hn::Set(d, direction.x()), x), hn::Mul(hn::Set(d, direction.y()), y));
    return hn::Add(inPlane, hn::Mul(hn::Set(d, direction.z()), z));
  }
};

HWY_INLINE PointLanes load(const LeafLanes& lanes, std::size_t at) {
  const Doubles d;
  return {hn::LoadU(d, lanes.x.data() + at), hn::LoadU(d, lanes.y.data() + at), hn::LoadU(d, lanes.z.data() + at)};
}

/// Whether the interval between two values overlaps a range.
HWY_INLINE hn::Mask<Doubles> meets(DoubleLanes from, DoubleLanes to, double low, double high) {
  const Doubles d;
  return hn::And(hn::Ge(hn::Max(from, to), hn::Set(d, low)), hn::Le(hn::Min(from, to), hn::Set(d, high)));
}

HWY_INLINE std::uint32_t pointsIn(const FaceRegion& region, const PointLanes& at) {
  const Doubles d;
  const auto height = at.along(region.normal);
  auto in = meets(height, height, region.low, region.high);
  in = hn::And(in, meets(at.x, at.x, region.box.min().x(), region.box.max().x()));
  in = hn::And(in, meets(at.y, at.y, region.box.min().y(), region.box.max().y()));
  in = hn::And(in, meets(at.z, at.z, region.box.min().z(), region.box.max().z()));
  const PointLanes fromCorner{hn::Sub(at.x, hn::Set(d, region.corner.x())),
                              hn::Sub(at.y, hn::Set(d, region.corner.y())),
                              hn::Sub(at.z, hn::Set(d, region.corner.z()))};
  const auto second = fromCorner.along(region.weights[0]);
  const auto third = fromCorner.along(region.weights[1]);
  in = hn::And(in, hn::Ge(hn::Min(second, third), hn::Zero(d)));
  in = hn::And(in, hn::Le(hn::Add(second, third), hn::Set(d, 1.0)));
  return bitsOf(in);
}

HWY_INLINE std::uint32_t edgesIn(const FaceRegion& region, const PointLanes& from, const PointLanes& to) {
  auto in = meets(from.along(region.normal), to.along(region.normal), region.low, region.high);
  in = hn::And(in, meets(from.x, to.x, region.box.min().x(), region.box.max().x()));
  in = hn::And(in, meets(from.y, to.y, region.box.min().y(), region.box.max().y()));
  in = hn::And(in, meets(from.z, to.z, region.box.min().z(), region.box.max().z()));
  return bitsOf(in);
}

void findInRegion(const LeafLanes& points, const std::size_t* begin, const EdgeLanes& edges,
                  const std::size_t* edgeBegin, const std::int32_t* leaves, std::size_t count, const FaceRegion& region,
                  InRegion* found) {
  const std::size_t step = hn::Lanes(Doubles());
  for (std::size_t k = 0; k < count; ++k) {
    const auto leaf = static_cast<std::size_t>(leaves[k]);
    InRegion in;
    for (std::size_t i = begin[leaf]; i < begin[leaf + 1]; i += step) {
      in.points |= pointsIn(region, load(points, i)) << (i - begin[leaf]);
    }
    for (std::size_t i = edgeBegin[leaf]; i < edgeBegin[leaf + 1]; i += step) {
      in.edges |= edgesIn(region, load(edges.from, i), load(edges.to, i)) << (i - edgeBegin[leaf]);
    }
    found[k] = in;
  }
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(meeting);
HWY_EXPORT(distances);
HWY_EXPORT(distancesToList);
HWY_EXPORT(extents);
HWY_EXPORT(support);
HWY_EXPORT(findInRegion);

void BoxList::add(const Eigen::AlignedBox3d& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (auto* bounds : {&low_[axis], &high_[axis]}) {
      if (bounds->size() < size_ + 1 + maxDoubles) {
        bounds->resize(2 * size_ + 1 + maxDoubles);
      }
    }
    low_[axis][size_] = box.min()[static_cast<Eigen::Index>(axis)];
    high_[axis][size_] = box.max()[static_cast<Eigen::Index>(axis)];
  }
  ++size_;
}

void boxesMeeting(const BoxList& boxes, const Eigen::AlignedBox3d& box, std::vector<std::int32_t>& met) {
  met.resize(boxes.size());
  met.resize(HWY_DYNAMIC_DISPATCH(meeting)(boxes, box, met.data()));
}

void squaredDistances(const BoxList& boxes, const Vec3& point, std::vector<double>& squared) {
  squared.resize(boxes.size() + maxDoubles);
  HWY_DYNAMIC_DISPATCH(distancesToList)(boxes, point, squared.data());
  squared.resize(boxes.size());
}

void squaredDistances(const std::vector<TriangleBoxes>& boxes, const std::vector<std::int32_t>& leaves,
                      const Vec3& point, std::vector<double>& squared) {
  squared.resize(trianglesPerLeaf * leaves.size());
  HWY_DYNAMIC_DISPATCH(distances)(boxes.data(), leaves.data(), leaves.size(), point, squared.data());
}

Extent extentsAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                    const std::vector<std::int32_t>& leaves, const Vec3& direction, std::vector<Extent>& result) {
  result.resize(leaves.size());
  return HWY_DYNAMIC_DISPATCH(extents)(lanes, begin.data(), leaves.data(), leaves.size(), direction, result.data());
}

SupportIndex supportAlong(const LeafLanes& lanes, const std::vector<std::size_t>& begin,
                          const std::vector<std::int32_t>& leaves, const Vec3& direction) {
  return HWY_DYNAMIC_DISPATCH(support)(lanes, begin.data(), leaves.data(), leaves.size(), direction);
}

void inRegion(const LeafLanes& points, const std::vector<std::size_t>& begin, const EdgeLanes& edges,
              const std::vector<std::size_t>& edgeBegin, const std::vector<std::int32_t>& leaves,
              const FaceRegion& region, std::vector<InRegion>& found) {
  found.resize(leaves.size());
  HWY_DYNAMIC_DISPATCH(findInRegion)
  (points, begin.data(), edges, edgeBegin.data(), leaves.data(), leaves.size(), region, found.data());
}

}  // namespace drape::sim::contact
#endif
