#include "sim/contact/constraints/primitive_search.hpp"

#include "sim/contact/recovery/overlap.hpp"

#include <algorithm>

namespace drape {

namespace {

/// What hangs on a pin cannot come out, and is not counted.
bool isFree(const ClothInBody& cloth, const Triangle& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int v) { return cloth.inverseMass[static_cast<std::size_t>(v)] > 0.0; });
}

}  // namespace

BodySearch::BodySearch(const BodyStep& step, int index, const ContactReach& reach) : side_(step, index, reach) {
  if (const auto* sphere = std::get_if<SphereShape>(&step.body->shape)) {
    radius_ = sphere->radius;
  } else if (const auto* capsule = std::get_if<CapsuleShape>(&step.body->shape)) {
    radius_ = capsule->radius;
    core_ = {Vec3(0.0, -capsule->halfLength, 0.0), Vec3(0.0, capsule->halfLength, 0.0)};
  } else {
    plane_ = true;
  }
}

double BodySearch::gapAt(const Vec3& place) const {
  if (plane_) {
    return place.y();
  }
  const Vec3 onCore = core_[0] + nearestOnSegment(place, core_[0], core_[1]) * (core_[1] - core_[0]);
  return (place - onCore).norm() - radius_;
}

void BodySearch::search(const ClothInBody& cloth, std::size_t begin, std::size_t end, Findings& findings) const {
  for (std::size_t t = begin; t < end; ++t) {
    if (plane_) {
      searchPlane(cloth, t, findings);
    } else {
      searchRound(cloth, t, findings);
    }
  }
}

void BodySearch::searchPlane(const ClothInBody& cloth, std::size_t t, Findings& findings) const {
  bool overlaps = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = cloth.triangles[t][k];
    const Vec3& base = vectorAt(cloth.base, v);
    const double gap = base.y();
    if (gap <= 0.0 && cloth.inverseMass[static_cast<std::size_t>(v)] > 0.0) {
      overlaps = true;
      findings.deepestOverlap = std::max(findings.deepestOverlap, -gap);
    }
    if (!cloth.owned[t].corners[k] || gap > side_.reach().keep + cloth.room[static_cast<std::size_t>(v)]) {
      continue;
    }
    const Vec3 foot(base.x(), 0.0, base.z());
    side_.addTouch(cloth, t, onCorner(k), {gap, Vec3::UnitY(), foot, foot}, side_.reach().keep, findings);
    if (gap > 0.0) {
      side_.addBarrier(v, Vec3::UnitY(), 0.0, gap, findings);
    }
  }
  findings.overlaps += overlaps ? 1 : 0;
}

void BodySearch::roundTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Vec3& onCore,
                            double keep, Findings& findings) const {
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  const Vec3 way = pointAt(base, weights) - onCore;
  const double distance = way.norm();
  const Vec3 normal = distance > 0.0 ? Vec3(way / distance) : faceNormal(base);
  const Vec3 point = onCore + radius_ * normal;
  side_.addTouch(cloth, t, weights, {distance - radius_, normal, point, point}, keep, findings);
}

void BodySearch::touchCorners(const ClothInBody& cloth, std::size_t t, const Corners& base, Findings& findings) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = cloth.triangles[t][k];
    if (!cloth.owned[t].corners[k]) {
      continue;
    }
    if (cloth.overlap != nullptr && cloth.overlap->inside(v)) {
      side_.addTouch(cloth, t, onCorner(k), cloth.overlap->exitOf(v), side_.reach().keep, findings);
      continue;
    }
    const Vec3 onCore = core_[0] + nearestOnSegment(base[k], core_[0], core_[1]) * (core_[1] - core_[0]);
    roundTouch(cloth, t, onCorner(k), onCore, side_.reach().keep, findings);
  }
}

void BodySearch::searchRound(const ClothInBody& cloth, std::size_t t, Findings& findings) const {
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  double room = 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.extend(base[k]);
    room = std::max(room, cloth.room[static_cast<std::size_t>(cloth.triangles[t][k])]);
  }
  const double far = radius_ + side_.reach().keep + room;
  const Eigen::AlignedBox3d core(core_[0] - Vec3::Constant(far), core_[1] + Vec3::Constant(far));
  if (!box.intersects(core)) {
    return;
  }
  TriangleSegmentPair nearest;
  if (core_[0] == core_[1]) {
    nearest.weights = nearestOnTriangle(core_[0], base);
  } else {
    nearest = nearestOfTriangleAndSegment(base, core_);
  }
  const auto coreAt = [&](double along) -> Vec3 { return core_[0] + along * (core_[1] - core_[0]); };
  const Vec3 onCore = coreAt(nearest.along);
  const Vec3 way = pointAt(base, nearest.weights) - onCore;
  const double distance = way.norm();
  if (distance > far) {
    return;
  }
  const Triangle& corners = cloth.triangles[t];
  const bool leaves = cloth.overlap != nullptr &&
                      std::any_of(corners.begin(), corners.end(), [&](int v) { return cloth.overlap->inside(v); });
  if (distance > radius_ && !leaves) {
    const Vec3 normal = way / distance;
    side_.addBarriers(cloth, t, normal, normal.dot(onCore) + radius_, distance - radius_, findings);
  } else if (distance <= radius_ && isFree(cloth, corners)) {
    ++findings.overlaps;
    findings.deepestOverlap = std::max(findings.deepestOverlap, radius_ - distance);
  }
  touchCorners(cloth, t, base, findings);
  if (leaves) {
    return;  // its corners know the way out
  }
  if (distance - radius_ > side_.reach().inner + room - 2.0 * side_.reach().keep) {
    return;  // edges and faces cannot come that near
  }
  if (isInside(nearest.weights)) {
    roundTouch(cloth, t, nearest.weights, onCore, side_.reach().inner, findings);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].sides[k]) {
      const SegmentPair pair = nearestOfSegments({base[k], base[(k + 1) % 3]}, core_);
      if (isInside(pair.first)) {
        roundTouch(cloth, t, onSide(k, pair.first), coreAt(pair.second), side_.reach().inner, findings);
      }
    }
  }
}

}  // namespace drape
