#include "sim/contact/body_search.hpp"

#include <algorithm>

namespace drape {

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
    overlaps = overlaps || gap <= 0.0;
    findings.deepestOverlap = std::max(findings.deepestOverlap, -gap);
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
  const Vec3 way = pointAt(cornersOf(cloth.base, cloth.triangles[t]), weights) - onCore;
  const double distance = way.norm();
  if (!(distance > 0.0)) {
    return;
  }
  const Vec3 normal = way / distance;
  const Vec3 point = onCore + radius_ * normal;
  side_.addTouch(cloth, t, weights, {distance - radius_, normal, point, point}, keep, findings);
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
  if (distance > radius_) {
    const Vec3 normal = way / distance;
    side_.addBarriers(cloth, t, normal, normal.dot(onCore) + radius_, distance - radius_, findings);
  } else {
    ++findings.overlaps;
    findings.deepestOverlap = std::max(findings.deepestOverlap, radius_ - distance);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].corners[k]) {
      roundTouch(cloth, t, onCorner(k), coreAt(nearestOnSegment(base[k], core_[0], core_[1])), side_.reach().keep,
                 findings);
    }
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
