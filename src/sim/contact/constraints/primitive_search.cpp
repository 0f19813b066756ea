#include "sim/contact/constraints/primitive_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/recovery/overlap.hpp"

#include <algorithm>

namespace drape::sim::contact {

namespace {

/// Whether no corner is pinned. Triangles with pinned corners cannot leave the body and do not count as overlaps.
bool hasNoPin(const ClothInBody& cloth, const Triangle& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](int v) { return cloth.inverseMass[v] > 0.0; });
}

}  // namespace

PrimitiveSearch::PrimitiveSearch(const BodyStep& step, int index, const ContactOffsets& offsets, double friction)
    : builder_(step, index, offsets, friction) {
  if (const auto* sphere = std::get_if<SphereShape>(&step.body->shape)) {
    radius_ = sphere->radius;
  } else if (const auto* capsule = std::get_if<CapsuleShape>(&step.body->shape)) {
    radius_ = capsule->radius;
    core_ = {Vec3(0.0, -capsule->halfLength, 0.0), Vec3(0.0, capsule->halfLength, 0.0)};
  } else {
    plane_ = true;
  }
}

double PrimitiveSearch::gapAt(const Vec3& position) const {
  if (plane_) {
    return position.y();
  }
  const Vec3 onCore = core_[0] + nearestOnSegment(position, core_[0], core_[1]) * (core_[1] - core_[0]);
  return (position - onCore).norm() - radius_;
}

void PrimitiveSearch::search(const ClothInBody& cloth, std::size_t begin, std::size_t end,
                             Candidates& candidates) const {
  for (std::size_t t = begin; t < end; ++t) {
    if (plane_) {
      searchPlane(cloth, t, candidates);
    } else {
      searchCapsule(cloth, t, candidates);
    }
  }
}

void PrimitiveSearch::searchPlane(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const {
  bool overlaps = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = cloth.triangles[t][k];
    const Vec3& start = vectorAt(cloth.start, v);
    const double gap = start.y();
    if (gap <= 0.0 && cloth.inverseMass[v] > 0.0) {
      overlaps = true;
      candidates.deepestOverlap = std::max(candidates.deepestOverlap, -gap);
    }
    if (!cloth.owned[t].corners[k] || gap > builder_.offsets().contactOffset + cloth.displacementBounds[v]) {
      continue;
    }
    const Vec3 foot(start.x(), 0.0, start.z());
    builder_.addContact(cloth, t, onCorner(k), {gap, Vec3::UnitY(), foot, foot}, builder_.offsets().contactOffset,
                        candidates);
    if (gap > 0.0) {
      builder_.addPlane(v, Vec3::UnitY(), 0.0, gap, candidates);
    }
  }
  candidates.overlaps += overlaps ? 1 : 0;
}

void PrimitiveSearch::addCapsuleContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights,
                                        const Vec3& onCore, double offset, Candidates& candidates) const {
  const Corners start = cornersOf(cloth.start, cloth.triangles[t]);
  const Vec3 fromCore = pointAt(start, weights) - onCore;
  const double distance = fromCore.norm();
  const Vec3 normal = distance > 0.0 ? Vec3(fromCore / distance) : faceNormal(start);
  const Vec3 point = onCore + radius_ * normal;
  builder_.addContact(cloth, t, weights, {distance - radius_, normal, point, point}, offset, candidates);
}

void PrimitiveSearch::addCornerContacts(const ClothInBody& cloth, std::size_t t, const Corners& start,
                                        Candidates& candidates) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = cloth.triangles[t][k];
    if (!cloth.owned[t].corners[k]) {
      continue;
    }
    if (cloth.overlap != nullptr && cloth.overlap->inside(v)) {
      builder_.addContact(cloth, t, onCorner(k), cloth.overlap->exitOf(v), builder_.offsets().contactOffset,
                          candidates);
      continue;
    }
    const Vec3 onCore = core_[0] + nearestOnSegment(start[k], core_[0], core_[1]) * (core_[1] - core_[0]);
    addCapsuleContact(cloth, t, onCorner(k), onCore, builder_.offsets().contactOffset, candidates);
  }
}

void PrimitiveSearch::searchCapsule(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const {
  const Corners start = cornersOf(cloth.start, cloth.triangles[t]);
  double bound = 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.extend(start[k]);
    bound = std::max(bound, cloth.displacementBounds[cloth.triangles[t][k]]);
  }
  const double far = radius_ + builder_.offsets().contactOffset + bound;
  const Eigen::AlignedBox3d core(core_[0] - Vec3::Constant(far), core_[1] + Vec3::Constant(far));
  if (!box.intersects(core)) {
    return;
  }
  TriangleSegmentPair nearest;
  if (core_[0] == core_[1]) {
    nearest.weights = nearestOnTriangle(core_[0], start);
  } else {
    nearest = nearestOfTriangleAndSegment(start, core_);
  }
  const auto coreAt = [&](double along) -> Vec3 { return core_[0] + along * (core_[1] - core_[0]); };
  const Vec3 onCore = coreAt(nearest.along);
  const Vec3 offset = pointAt(start, nearest.weights) - onCore;
  const double distance = offset.norm();
  if (distance > far) {
    return;
  }
  const Triangle& corners = cloth.triangles[t];
  const bool isLeaving = cloth.overlap != nullptr &&
                         std::any_of(corners.begin(), corners.end(), [&](int v) { return cloth.overlap->inside(v); });
  if (distance > radius_ && !isLeaving) {
    const Vec3 normal = offset / distance;
    builder_.addPlanes(cloth, t, normal, normal.dot(onCore) + radius_, distance - radius_, candidates);
  } else if (distance <= radius_ && hasNoPin(cloth, corners)) {
    ++candidates.overlaps;
    candidates.deepestOverlap = std::max(candidates.deepestOverlap, radius_ - distance);
  }
  addCornerContacts(cloth, t, start, candidates);
  if (isLeaving) {
    return;  // its corners have their exits
  }
  if (distance - radius_ > builder_.offsets().edgeOffset + bound - 2.0 * builder_.offsets().contactOffset) {
    return;  // edges and faces stay too far away
  }
  if (isInside(nearest.weights)) {
    addCapsuleContact(cloth, t, nearest.weights, onCore, builder_.offsets().edgeOffset, candidates);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].sides[k]) {
      const SegmentPair pair = nearestOfSegments({start[k], start[(k + 1) % 3]}, core_);
      if (isInside(pair.first)) {
        addCapsuleContact(cloth, t, onSide(k, pair.first), coreAt(pair.second), builder_.offsets().edgeOffset,
                          candidates);
      }
    }
  }
}

}  // namespace drape::sim::contact
