#include "sim/contact/constraints/sharp_feature_search.hpp"

#include <algorithm>

namespace drape {

/// Finds what is near a triangle; false where nothing is.
bool SharpSearch::place(int t, const std::vector<int>& patches, const BoxList& boxes) {
  t_ = static_cast<std::size_t>(t);
  base_ = cornersOf(cloth_.base, cloth_.triangles[t_]);
  boxesMeeting(boxes, inflated(boxAround(base_), near_), patches_);
  for (std::int32_t& each : patches_) {
    each = patches[static_cast<std::size_t>(each)];
  }
  normal_ = faceNormal(base_);
  return !patches_.empty();
}

/// The triangle's normal, away from where the mesh is for the corner that is nearest to it.
Vec3 SharpSearch::ownOutwards() const {
  const NearVertex* first = nullptr;
  for (const int v : cloth_.triangles[t_]) {
    const NearVertex& near = nearest_[static_cast<std::size_t>(v)];
    first = near.triangle >= 0 && (first == nullptr || near.gap < first->gap) ? &near : first;
  }
  return first != nullptr && first->normal.dot(normal_) < 0.0 ? Vec3(-normal_) : normal_;
}

double SharpSearch::look(int t, const std::vector<int>& patches, const BoxList& boxes, double way, Vec3& outwards) {
  if (!place(t, patches, boxes)) {
    return near_;
  }
  const ContactReach& reach = side_.reach();
  const double wanted = mesh_.mesh.movesInItself() ? close_ : std::min(close_, reach.inner + way);
  const HullGap gap = HullGapSearch(mesh_.mesh, mesh_.settled, patches_, base_)
                          .search(outwards.isZero() ? ownOutwards() : outwards, {wanted, way + reach.guard});
  outwards = gap.normal;
  const double distance = std::min(gap.atLeast, near_);
  if (distance < wanted) {
    lookAround(patches, boxes);
  }
  return distance;
}

FaceRegion SharpSearch::region() const {
  FaceRegion region{inflated(boxAround(base_), close_), normal_, lowestAlong(normal_, base_) - close_,
                    highestAlong(normal_, base_) + close_, base_[0]};
  const Vec3 ab = base_[1] - base_[0];
  const Vec3 ac = base_[2] - base_[0];
  const Vec3 across = ab.cross(ac);
  const double area = across.squaredNorm();
  constexpr double thin = 1e-12;  // squared sine of the angle between two sides: of slivers all points count
  if (area > thin * ab.squaredNorm() * ac.squaredNorm()) {
    region.weights = {ac.cross(across) / area, across.cross(ab) / area};
  }
  return region;
}

/// Looks at the points and edges that are close.
void SharpSearch::lookAround(const std::vector<int>& patches, const BoxList& boxes) {
  const FaceRegion close = region();
  boxesMeeting(boxes, close.box, patches_);
  for (std::int32_t& each : patches_) {
    each = patches[static_cast<std::size_t>(each)];
  }
  mesh_.mesh.featuresIn(close, patches_, mesh_.settled, found_);
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    mesh_.mesh.forEachFeature(static_cast<std::size_t>(patches_[i]), found_[i],
                              [&](const MeshFeature& feature, bool isEdge) {
                                if (isEdge) {
                                  touchEdge(feature.triangle, feature.at);
                                } else {
                                  touchPoint(feature.triangle, feature.at);
                                }
                              });
  }
}

void SharpSearch::touch(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights) {
  const Vec3 way = pointAt(base_, weights) - pointAt(at, bodyWeights);
  const double gap = way.norm();
  if (gap < close_ && gap > 0.0) {
    const NearPoint near{gap, way / gap, pointAt(mesh_.start(bodyTriangle), bodyWeights),
                         pointAt(mesh_.end(bodyTriangle), bodyWeights)};
    side_.addTouch(cloth_, t_, weights, near, side_.reach().inner, findings_);
  }
}

void SharpSearch::touchPoint(int bodyTriangle, std::size_t corner) {
  const Corners at = mesh_.base(bodyTriangle);
  const Vec3 weights = nearestOnTriangle(at[corner], base_);
  if (isInside(weights)) {
    touch(bodyTriangle, at, weights, onCorner(corner));
  }
}

void SharpSearch::touchEdge(int bodyTriangle, std::size_t side) {
  const Corners at = mesh_.base(bodyTriangle);
  const Vec3& from = at[side];
  const Vec3& to = at[(side + 1) % 3];
  const Eigen::AlignedBox3d around(from.cwiseMin(to).array() - close_, from.cwiseMax(to).array() + close_);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = base_[k];
    const Vec3& b = base_[(k + 1) % 3];
    if (!cloth_.owned[t_].sides[k] || !around.intersects(Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b)))) {
      continue;
    }
    const SegmentPair pair = nearestOfSegments({a, b}, {from, to});
    if (isInside(pair.first) && isInside(pair.second)) {
      touch(bodyTriangle, at, onSide(k, pair.first), onSide(side, pair.second));
    }
  }
}

}  // namespace drape
