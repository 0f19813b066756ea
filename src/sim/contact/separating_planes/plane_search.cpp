#include "sim/contact/separating_planes/plane_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>

namespace drape::sim::contact {

void PlaneSearch::prepare() {
  const Triangle& corners = cloth_.triangles[t_];
  maxBound_ = 0.0;
  reachableBox_.setEmpty();
  for (std::size_t k = 0; k < 3; ++k) {
    const double bound = cloth_.displacementBounds[corners[k]];
    const double far = bound + builder_.offsets().minimumSeparation;
    reachableBox_.extend((start_[k].array() - far).matrix());
    reachableBox_.extend((start_[k].array() + far).matrix());
    maxBound_ = std::max(maxBound_, bound);
  }
}

void PlaneSearch::search(int t, const std::vector<int>& leaves, const BoxList& boxes) {
  t_ = static_cast<std::size_t>(t);
  start_ = cornersOf(cloth_.start, cloth_.triangles[t_]);
  predicted_ = cornersOf(cloth_.predicted, cloth_.triangles[t_]);
  prepare();
  boxesMeeting(boxes, reachableBox_, leaves_);
  for (std::int32_t& each : leaves_) {
    each = leaves[each];
  }
  if (leaves_.empty()) {
    return;
  }
  normals_.clear();
  if (!separateAtOnce()) {
    coverSome();
    separateRest();
  }
}

/// Tries to separate all leaves by one plane.
bool PlaneSearch::separateAtOnce() {
  std::array<const NearestMeshPoint*, 3> near{};
  for (std::size_t k = 0; k < 3; ++k) {
    near[k] = &nearest_[cloth_.triangles[t_][k]];
  }
  std::stable_sort(near.begin(), near.end(), [](const auto* a, const auto* b) { return a->gap < b->gap; });
  if (!mesh_.moves()) {
    const bool separate = offerWidestGap(near[0]->triangle >= 0 ? near[0]->normal : faceNormal(start_));
    for (const NearestMeshPoint* each : near) {
      if (!separate && each->triangle >= 0) {
        normals_.push_back(each->normal);
      }
    }
    return separate;
  }
  return std::any_of(near.begin(), near.end(),
                     [&](const NearestMeshPoint* each) { return each->triangle >= 0 && offer(each->normal); }) ||
         offerOwnPlane();
}

/// Tries the plane in the widest gap between a rigid mesh and the triangle at its start and its predicted positions. It
/// exists if their convex hulls are disjoint.
bool PlaneSearch::offerWidestGap(const Vec3& along) {
  const std::array<Vec3, 6> points{start_[0], start_[1], start_[2], predicted_[0], predicted_[1], predicted_[2]};
  const double minimumSeparation = builder_.offsets().minimumSeparation;
  const HullGap gap =
      HullGapSearch(mesh_.mesh, mesh_.atEnd, leaves_, points).search(along, {minimumSeparation, minimumSeparation});
  normals_.push_back(gap.normal);
  if (gap.atLeast < minimumSeparation) {
    return false;
  }
  Plane plane = planeAlong(gap.normal);
  plane.cover(gap.top, gap.top);
  addPlanes(plane);
  return true;
}

/// Tries the plane of the triangle, and the plane normal to the offset between the triangle and the vertex of the mesh
/// that protrudes most towards it.
bool PlaneSearch::offerOwnPlane() {
  const Vec3 across = (start_[1] - start_[0]).cross(start_[2] - start_[0]);
  const double length = across.norm();
  if (!(length > 0.0)) {
    return false;
  }
  Vec3 normal = across / length;
  const Extent all = mesh_.mesh.extentsAlong(normal, leaves_, mesh_.atEnd, extents_);
  if (all.low - highestAlong(normal, start_) > lowestAlong(normal, start_) - all.high) {
    normal = -normal;
  }
  if (offer(normal)) {
    return true;
  }
  const auto highest = std::max_element(extents_.begin(), extents_.end(),
                                        [](const Extent& a, const Extent& b) { return a.high < b.high; });
  const auto top = static_cast<std::size_t>(highest - extents_.begin());
  const int v = mesh_.mesh.supportVertex(normal, static_cast<std::size_t>(leaves_[top]), mesh_.atEnd);
  const Vec3& point = vectorAt(mesh_.positions(), v);
  const Vec3 offset = pointAt(start_, nearestOnTriangle(point, start_)) - point;
  const double distance = offset.norm();
  return distance > 0.0 && offer(offset / distance);
}

PlaneSearch::Plane PlaneSearch::planeAlong(const Vec3& normal) const {
  Plane plane;
  plane.normal = normal;
  plane.startLow = lowestAlong(normal, start_);
  plane.predictedLow = lowestAlong(normal, predicted_);
  return plane;
}

/// Whether the plane separates a part of the mesh and does not restrict the motion: the triangle is far enough above
/// the part at its start and at its predicted positions.
bool PlaneSearch::covers(const Plane& plane, double startTop, double endTop) const {
  const double minimumSeparation = builder_.offsets().minimumSeparation;
  return plane.startLow - startTop >= minimumSeparation && plane.predictedLow - endTop >= minimumSeparation;
}

/// Computes the extents of the leaves along a normal.
void PlaneSearch::measure(const Vec3& normal) {
  mesh_.mesh.extentsAlong(normal, leaves_, mesh_.atEnd, extents_);
  if (mesh_.moves()) {
    mesh_.mesh.extentsAlong(normal, leaves_, true, endExtents_);
  } else {
    endExtents_ = extents_;
  }
}

bool PlaneSearch::offer(const Vec3& normal) {
  normals_.push_back(normal);
  measure(normal);
  Plane plane = planeAlong(normal);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    plane.cover(extents_[i].high, endExtents_[i].high);
  }
  if (covers(plane, plane.startTop, plane.endTop)) {
    addPlanes(plane);
    return true;
  }
  return false;
}

/// Uses the plane that separates most leaves, and collects in `rest_` the triangles of the mesh that it does not
/// separate.
void PlaneSearch::coverSome() {
  Plane best;
  std::size_t maxCovered = 0;
  for (const Vec3& normal : normals_) {
    const Plane plane = planeAlong(normal);
    measure(normal);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      covered += covers(plane, extents_[i].high, endExtents_[i].high) ? 1 : 0;
    }
    if (covered > maxCovered) {
      maxCovered = covered;
      best = plane;
    }
  }
  rest_.clear();
  for (const int leaf : leaves_) {
    for (const int triangle : mesh_.mesh.tree.leaf(static_cast<std::size_t>(leaf))) {
      const double top = highestAlong(best.normal, mesh_.corners(triangle));
      const double endTop = mesh_.moves() ? highestAlong(best.normal, mesh_.endCorners(triangle)) : top;
      if (maxCovered > 0 && covers(best, top, endTop)) {
        best.cover(top, endTop);
      } else if (mesh_.moves() || !outOfReach(normals_, triangle)) {
        rest_.push_back({triangle, false});
      }
    }
  }
  if (maxCovered > 0) {
    addPlanes(best);
  }
}

/// Whether the extents along one of the normals show that a triangle of a rigid mesh is out of reach.
bool PlaneSearch::outOfReach(const std::vector<Vec3>& normals, int triangle) const {
  const Corners at = mesh_.corners(triangle);
  const double far = maxBound_ + builder_.offsets().minimumSeparation;
  return std::any_of(normals.begin(), normals.end(), [&](const Vec3& normal) {
    return lowestAlong(normal, start_) - highestAlong(normal, at) > far ||
           lowestAlong(normal, at) - highestAlong(normal, start_) > far;
  });
}

void PlaneSearch::addPlanes(const Plane& plane) {
  builder_.addPlanes(cloth_, t_, plane.normal, plane.endTop, plane.startLow - plane.startTop, candidates_);
}

void PlaneSearch::separateRest() {
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (!rest_[i].done) {
      separateOne(i);
    }
  }
}

/// Finds a plane at the closest points of a triangle of the mesh, and uses it for the other triangles that it
/// separates.
void PlaneSearch::separateOne(std::size_t first) {
  const int triangle = rest_[first].triangle;
  const Corners at = mesh_.corners(triangle);
  const Corners end = mesh_.endCorners(triangle);
  if (!boxAround(at).merged(boxAround(end)).intersects(reachableBox_)) {
    return;
  }
  double far = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    far = std::max(far, (end[k] - at[k]).norm());
  }
  far += maxBound_ + builder_.offsets().minimumSeparation;
  const Vec3 face = faceNormal(at);
  const double height = face.dot(at[0]);
  if (lowestAlong(face, start_) - height > far || height - highestAlong(face, start_) > far) {
    return;
  }
  const TriangleGap gap = gapOfTriangles(start_, at);
  if (gap.distance > far) {
    return;
  }
  if (!(gap.distance > 0.0)) {
    piercings_.push_back({static_cast<int>(t_), triangle});
    return;
  }
  Plane plane = planeAlong(gap.normal);
  plane.cover(plane.startLow - gap.distance, highestAlong(gap.normal, end));
  if (!covers(plane, plane.startTop, plane.endTop)) {
    // This plane restricts the predicted motion. Tries the plane between both at the end of the step.
    Plane other = planeAlong(gapOfTriangles(predicted_, end).normal);
    other.cover(highestAlong(other.normal, at), highestAlong(other.normal, end));
    plane = covers(other, other.startTop, other.endTop) ? other : plane;
  }
  for (std::size_t i = first + 1; i < rest_.size(); ++i) {
    if (rest_[i].done) {
      continue;
    }
    const double top = highestAlong(plane.normal, mesh_.corners(rest_[i].triangle));
    const double endTop = mesh_.moves() ? highestAlong(plane.normal, mesh_.endCorners(rest_[i].triangle)) : top;
    if ((top <= plane.startTop && endTop <= plane.endTop) || covers(plane, top, endTop)) {
      plane.cover(top, endTop);
      rest_[i].done = true;
    }
  }
  addPlanes(plane);
}

}  // namespace drape::sim::contact
