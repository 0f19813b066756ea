#include "sim/contact/separating_planes/plane_search.hpp"

#include <algorithm>

namespace drape {

void PlaneSearch::place() {
  const Triangle& corners = cloth_.triangles[t_];
  room_ = 0.0;
  reach_.setEmpty();
  for (std::size_t k = 0; k < 3; ++k) {
    const double room = cloth_.room[static_cast<std::size_t>(corners[k])];
    const double far = room + side_.reach().guard;
    reach_.extend((base_[k].array() - far).matrix());
    reach_.extend((base_[k].array() + far).matrix());
    room_ = std::max(room_, room);
  }
}

void PlaneSearch::look(int t, const std::vector<int>& patches, const BoxList& boxes) {
  t_ = static_cast<std::size_t>(t);
  base_ = cornersOf(cloth_.base, cloth_.triangles[t_]);
  target_ = cornersOf(cloth_.target, cloth_.triangles[t_]);
  place();
  boxesMeeting(boxes, reach_, patches_);
  for (std::int32_t& each : patches_) {
    each = patches[static_cast<std::size_t>(each)];
  }
  if (patches_.empty()) {
    return;
  }
  normals_.clear();
  if (!separateAtOnce()) {
    coverSome();
    separateRest();
  }
}

/// Tries what is cheap: one plane for all.
bool PlaneSearch::separateAtOnce() {
  std::array<const NearVertex*, 3> near{};
  for (std::size_t k = 0; k < 3; ++k) {
    near[k] = &nearest_[static_cast<std::size_t>(cloth_.triangles[t_][k])];
  }
  std::stable_sort(near.begin(), near.end(), [](const auto* a, const auto* b) { return a->gap < b->gap; });
  if (!mesh_.moves()) {
    const bool separate = offerWidestGap(near[0]->triangle >= 0 ? near[0]->normal : faceNormal(base_));
    for (const NearVertex* each : near) {
      if (!separate && each->triangle >= 0) {
        normals_.push_back(each->normal);
      }
    }
    return separate;
  }
  return std::any_of(near.begin(), near.end(),
                     [&](const NearVertex* each) { return each->triangle >= 0 && offer(each->normal); }) ||
         offerOwnPlane();
}

/// Looks for the direction in which a mesh that stands still is farthest from the triangle, at its base and where it
/// goes. Where their hulls are apart there is one.
bool PlaneSearch::offerWidestGap(const Vec3& along) {
  const std::array<Vec3, 6> points{base_[0], base_[1], base_[2], target_[0], target_[1], target_[2]};
  const double guard = side_.reach().guard;
  const HullGap gap = HullGapSearch(mesh_.mesh, mesh_.settled, patches_, points).search(along, {guard, guard});
  normals_.push_back(gap.normal);
  if (gap.atLeast < guard) {
    return false;
  }
  Plane plane = planeAlong(gap.normal);
  plane.cover(gap.top, gap.top);
  raise(plane);
  return true;
}

/// Tries the plane in which the triangle lies, and the one across the way from it to what sticks out most.
bool PlaneSearch::offerOwnPlane() {
  const Vec3 across = (base_[1] - base_[0]).cross(base_[2] - base_[0]);
  const double length = across.norm();
  if (!(length > 0.0)) {
    return false;
  }
  Vec3 normal = across / length;
  const Extent all = mesh_.mesh.extentsAlong(normal, patches_, mesh_.settled, extents_);
  if (all.low - highestAlong(normal, base_) > lowestAlong(normal, base_) - all.high) {
    normal = -normal;
  }
  if (offer(normal)) {
    return true;
  }
  const auto highest = std::max_element(extents_.begin(), extents_.end(),
                                        [](const Extent& a, const Extent& b) { return a.high < b.high; });
  const auto top = static_cast<std::size_t>(highest - extents_.begin());
  const int v = mesh_.mesh.farthestAlong(normal, static_cast<std::size_t>(patches_[top]), mesh_.settled);
  const Vec3& point = vectorAt(mesh_.atBase(), v);
  const Vec3 way = pointAt(base_, nearestOnTriangle(point, base_)) - point;
  const double distance = way.norm();
  return distance > 0.0 && offer(way / distance);
}

PlaneSearch::Plane PlaneSearch::planeAlong(const Vec3& normal) const {
  Plane plane;
  plane.normal = normal;
  plane.baseLow = lowestAlong(normal, base_);
  plane.endLow = lowestAlong(normal, target_);
  return plane;
}

/// Whether the cloth is, and goes on to be, so far above that a plane between needs not stop it.
bool PlaneSearch::covers(const Plane& plane, double baseTop, double endTop) const {
  const double guard = side_.reach().guard;
  return plane.baseLow - baseTop >= guard && plane.endLow - endTop >= guard;
}

/// Finds how far the patches reach along a normal.
void PlaneSearch::measure(const Vec3& normal) {
  mesh_.mesh.extentsAlong(normal, patches_, mesh_.settled, extents_);
  if (mesh_.moves()) {
    mesh_.mesh.extentsAlong(normal, patches_, true, endExtents_);
  } else {
    endExtents_ = extents_;
  }
}

bool PlaneSearch::offer(const Vec3& normal) {
  normals_.push_back(normal);
  measure(normal);
  Plane plane = planeAlong(normal);
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    plane.cover(extents_[i].high, endExtents_[i].high);
  }
  if (covers(plane, plane.baseTop, plane.endTop)) {
    raise(plane);
    return true;
  }
  return false;
}

/// Takes the plane that covers most, and leaves to `rest_` what it does not.
void PlaneSearch::coverSome() {
  Plane best;
  std::size_t most = 0;
  for (const Vec3& normal : normals_) {
    const Plane plane = planeAlong(normal);
    measure(normal);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      covered += covers(plane, extents_[i].high, endExtents_[i].high) ? 1 : 0;
    }
    if (covered > most) {
      most = covered;
      best = plane;
    }
  }
  rest_.clear();
  for (const int patch : patches_) {
    for (const int triangle : mesh_.mesh.tree.leaf(static_cast<std::size_t>(patch))) {
      const double top = highestAlong(best.normal, mesh_.base(triangle));
      const double endTop = mesh_.moves() ? highestAlong(best.normal, mesh_.end(triangle)) : top;
      if (most > 0 && covers(best, top, endTop)) {
        best.cover(top, endTop);
      } else if (mesh_.moves() || !outOfReach(normals_, triangle)) {
        rest_.push_back({triangle, false});
      }
    }
  }
  if (most > 0) {
    raise(best);
  }
}

/// Whether one of the normals shows that a triangle of the body, which does not move, is too far away to be met.
bool PlaneSearch::outOfReach(const std::vector<Vec3>& normals, int triangle) const {
  const Corners at = mesh_.base(triangle);
  const double far = room_ + side_.reach().guard;
  return std::any_of(normals.begin(), normals.end(), [&](const Vec3& normal) {
    return lowestAlong(normal, base_) - highestAlong(normal, at) > far ||
           lowestAlong(normal, at) - highestAlong(normal, base_) > far;
  });
}

void PlaneSearch::raise(const Plane& plane) {
  side_.addBarriers(cloth_, t_, plane.normal, plane.endTop, plane.baseLow - plane.baseTop, findings_);
}

void PlaneSearch::separateRest() {
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (!rest_[i].done) {
      separateOne(i);
    }
  }
}

/// Finds the plane through the nearest points of a triangle of the body, and covers with it what else it can.
void PlaneSearch::separateOne(std::size_t first) {
  const int triangle = rest_[first].triangle;
  const Corners at = mesh_.base(triangle);
  const Corners end = mesh_.end(triangle);
  if (!boxAround(at).merged(boxAround(end)).intersects(reach_)) {
    return;
  }
  double far = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    far = std::max(far, (end[k] - at[k]).norm());
  }
  far += room_ + side_.reach().guard;
  const Vec3 face = faceNormal(at);
  const double height = face.dot(at[0]);
  if (lowestAlong(face, base_) - height > far || height - highestAlong(face, base_) > far) {
    return;
  }
  const TriangleGap gap = gapOfTriangles(base_, at);
  if (gap.distance > far) {
    return;
  }
  if (!(gap.distance > 0.0)) {
    piercings_.push_back({static_cast<int>(t_), triangle});
    return;
  }
  Plane plane = planeAlong(gap.normal);
  plane.cover(plane.baseLow - gap.distance, highestAlong(gap.normal, end));
  if (!covers(plane, plane.baseTop, plane.endTop)) {
    // Where it would stop the cloth, the plane between where both go may do at the base as well.
    Plane other = planeAlong(gapOfTriangles(target_, end).normal);
    other.cover(highestAlong(other.normal, at), highestAlong(other.normal, end));
    plane = covers(other, other.baseTop, other.endTop) ? other : plane;
  }
  for (std::size_t i = first + 1; i < rest_.size(); ++i) {
    if (rest_[i].done) {
      continue;
    }
    const double top = highestAlong(plane.normal, mesh_.base(rest_[i].triangle));
    const double endTop = mesh_.moves() ? highestAlong(plane.normal, mesh_.end(rest_[i].triangle)) : top;
    if ((top <= plane.baseTop && endTop <= plane.endTop) || covers(plane, top, endTop)) {
      plane.cover(top, endTop);
      rest_[i].done = true;
    }
  }
  raise(plane);
}

}  // namespace drape
