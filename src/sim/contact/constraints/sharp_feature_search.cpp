#include "sim/contact/constraints/sharp_feature_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>

namespace drape::sim::contact {

/// Finds the leaves near a triangle; false if there are none.
bool SharpFeatureSearch::findNearbyLeaves(int t, const std::vector<int>& leaves, const BoxList& boxes) {
  t_ = static_cast<std::size_t>(t);
  start_ = cornersOf(cloth_.start, cloth_.triangles[t_]);
  boxesMeeting(boxes, inflated(boxAround(start_), near_), leaves_);
  for (std::int32_t& each : leaves_) {
    each = leaves[each];
  }
  normal_ = faceNormal(start_);
  return !leaves_.empty();
}

/// The triangle's normal, oriented away from the mesh at the corner that is closest to it.
Vec3 SharpFeatureSearch::outwardNormal() const {
  const NearestMeshPoint* first = nullptr;
  for (const int v : cloth_.triangles[t_]) {
    const NearestMeshPoint& near = nearest_[v];
    first = near.triangle >= 0 && (first == nullptr || near.gap < first->gap) ? &near : first;
  }
  return first != nullptr && first->normal.dot(normal_) < 0.0 ? Vec3(-normal_) : normal_;
}

double SharpFeatureSearch::search(int t, const std::vector<int>& leaves, const BoxList& boxes, double maxDisplacement,
                                  Vec3& outwards) {
  if (!findNearbyLeaves(t, leaves, boxes)) {
    return near_;
  }
  const ContactOffsets& offsets = builder_.offsets();
  const double wanted = mesh_.mesh.isDeforming() ? close_ : std::min(close_, offsets.edgeOffset + maxDisplacement);
  const HullGap gap = HullGapSearch(mesh_.mesh, mesh_.atEnd, leaves_, start_)
                          .search(outwards.isZero() ? outwardNormal() : outwards,
                                  {wanted, maxDisplacement + offsets.minimumSeparation});
  outwards = gap.normal;
  const double distance = std::min(gap.atLeast, near_);
  if (distance < wanted) {
    searchFeatures(leaves, boxes);
  }
  return distance;
}

FaceRegion SharpFeatureSearch::region() const {
  FaceRegion region{inflated(boxAround(start_), close_), normal_, lowestAlong(normal_, start_) - close_,
                    highestAlong(normal_, start_) + close_, start_[0]};
  const Vec3 ab = start_[1] - start_[0];
  const Vec3 ac = start_[2] - start_[0];
  const Vec3 across = ab.cross(ac);
  const double area = across.squaredNorm();
  constexpr double thin = 1e-12;  // squared sine of the angle between two sides; for slivers all points count
  if (area > thin * ab.squaredNorm() * ac.squaredNorm()) {
    region.weights = {ac.cross(across) / area, across.cross(ab) / area};
  }
  return region;
}

/// Adds contacts of the vertices and edges that are close.
void SharpFeatureSearch::searchFeatures(const std::vector<int>& leaves, const BoxList& boxes) {
  const FaceRegion close = region();
  boxesMeeting(boxes, close.box, leaves_);
  for (std::int32_t& each : leaves_) {
    each = leaves[each];
  }
  mesh_.mesh.featuresIn(close, leaves_, mesh_.atEnd, found_);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    mesh_.mesh.forEachFeature(static_cast<std::size_t>(leaves_[i]), found_[i],
                              [&](const MeshFeature& feature, bool isEdge) {
                                if (isEdge) {
                                  addEdgeContact(feature.triangle, feature.at);
                                } else {
                                  addVertexContact(feature.triangle, feature.at);
                                }
                              });
  }
}

void SharpFeatureSearch::contact(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights) {
  const Vec3 offset = pointAt(start_, weights) - pointAt(at, bodyWeights);
  const double gap = offset.norm();
  if (gap < close_ && gap > 0.0) {
    const NearPoint near{gap, offset / gap, pointAt(mesh_.startCorners(bodyTriangle), bodyWeights),
                         pointAt(mesh_.endCorners(bodyTriangle), bodyWeights)};
    builder_.addContact(cloth_, t_, weights, near, builder_.offsets().edgeOffset, candidates_);
  }
}

void SharpFeatureSearch::addVertexContact(int bodyTriangle, std::size_t corner) {
  const Corners at = mesh_.corners(bodyTriangle);
  const Vec3 weights = nearestOnTriangle(at[corner], start_);
  if (isInside(weights)) {
    contact(bodyTriangle, at, weights, onCorner(corner));
  }
}

void SharpFeatureSearch::addEdgeContact(int bodyTriangle, std::size_t side) {
  const Corners at = mesh_.corners(bodyTriangle);
  const Vec3& from = at[side];
  const Vec3& to = at[(side + 1) % 3];
  const Eigen::AlignedBox3d around(from.cwiseMin(to).array() - close_, from.cwiseMax(to).array() + close_);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = start_[k];
    const Vec3& b = start_[(k + 1) % 3];
    if (!cloth_.owned[t_].sides[k] || !around.intersects(Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b)))) {
      continue;
    }
    const SegmentPair pair = nearestOfSegments({a, b}, {from, to});
    if (isInside(pair.first) && isInside(pair.second)) {
      contact(bodyTriangle, at, onSide(k, pair.first), onSide(side, pair.second));
    }
  }
}

}  // namespace drape::sim::contact
