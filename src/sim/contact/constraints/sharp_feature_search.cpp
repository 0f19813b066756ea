#include "sim/contact/constraints/sharp_feature_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr double slackRatio = 0.15;        // features are cached for this displacement, over the contact offset [-]
constexpr double minStepsInMemory = 3.0;   // a cached result must be valid for so many steps
constexpr double positionRounding = 1e-9;  // [m]

/// A distance in float that is not above `distance` [m].
float floatBelow(double distance) {
  return std::nextafter(static_cast<float>(distance), 0.0F);
}

}  // namespace

/// Finds the leaves near the triangle; false if there are none.
bool SharpFeatureSearch::findNearbyLeaves(const std::vector<int>& leaves, const BoxList& boxes, double near) {
  boxesMeeting(boxes, inflated(boxAround(start_), near), leaves_);
  for (std::int32_t& each : leaves_) {
    each = leaves[each];
  }
  if (leaves_.empty()) {
    return false;
  }
  normal_ = faceNormal(start_);
  return true;
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

/// Adds the contacts of cached features; false if the cached result is not valid.
/// @param wanted distance up to which features can get contacts [m]
/// @param distance set to a lower bound of the distance to the mesh [m]
bool SharpFeatureSearch::useMemory(const NearbyFeatures& memory, double wanted, double& distance) {
  if (memory.validRadius < 0.0 || wanted > memory.complete) {
    return false;
  }
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    squared = std::max(squared, (start_[k] - memory.at[k]).squaredNorm());
  }
  const double moved = squared > 0.0 ? std::sqrt(squared) + positionRounding : 0.0;
  if (moved > memory.validRadius) {
    return false;
  }
  featureGap_ = std::max(wanted, memory.complete + memory.validRadius - moved);
  bool haveWeights = false;
  for (const NearbyFeatures::Feature& feature : memory.features) {
    const double atLeast = feature.atLeast - moved;
    if (atLeast >= wanted) {
      featureGap_ = std::min(featureGap_, atLeast);
      continue;
    }
    if (!std::exchange(haveWeights, true)) {
      computeFaceWeights();
    }
    if (feature.sides == 0) {
      addVertexContact(feature.triangle, feature.at);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if ((feature.sides >> k & 1U) != 0) {
        addEdgeContact(feature.triangle, feature.at, k);
      }
    }
  }
  distance = memory.distance - moved;
  return true;
}

double SharpFeatureSearch::search(int t, const std::vector<int>& leaves, const BoxList& boxes, double maxDisplacement,
                                  Vec3& outwards, NearbyFeatures& memory) {
  const ContactOffsets& offsets = builder_.offsets();
  t_ = static_cast<std::size_t>(t);
  start_ = cornersOf(cloth_.start, cloth_.triangles[t_]);
  const bool rigid = !mesh_.mesh.isDeforming();
  const double wanted = rigid ? std::min(close_, offsets.edgeOffset + maxDisplacement) : close_;
  double distance = 0.0;
  if (useMemory(memory, wanted, distance)) {
    return distance;
  }
  // To cache more than this step needs pays only if the triangle moves so little that the result stays valid.
  const double slack = slackRatio * offsets.contactOffset;
  const bool slow = rigid && minStepsInMemory * (maxDisplacement - offsets.listMargin) <= slack;
  memory.features.clear();
  memory.at = start_;
  // The search at the end of a contact substep starts from the same positions as that for its list of substep contacts.
  const bool usedAgain = slow || offsets.listMargin > 0.0;
  const double far = wanted + (slow ? slack : 0.0);
  memory.validRadius = slow ? slack : usedAgain ? 0.0 : -1.0;
  memory.complete = wanted;
  const double near = std::max(near_, far);
  distance = near;
  if (findNearbyLeaves(leaves, boxes, near)) {
    const HullGap gap =
        HullGapSearch(mesh_.mesh, mesh_.atEnd, leaves_, start_)
            .search(outwards.isZero() ? outwardNormal() : outwards, {far, maxDisplacement + offsets.minimumSeparation});
    outwards = gap.normal;
    distance = std::min(gap.atLeast, near);
  }
  memory.distance = distance;
  featureGap_ = far;
  if (distance < far) {
    searchFeatures(leaves, boxes, slow ? slack : 0.0, memory);
  }
  return distance;
}

/// The region of features that can come closer than `close_` after a displacement of `slack` [m].
FaceRegion SharpFeatureSearch::region(double slack) const {
  const double far = close_ + slack;
  FaceRegion region{inflated(boxAround(start_), far), normal_, lowestAlong(normal_, start_) - far,
                    highestAlong(normal_, start_) + far, start_[0]};
  if (slack == 0.0) {
    region.weights = faceWeights_;  // with slack, a point beside the face may lie over it later
  }
  return region;
}

void SharpFeatureSearch::computeFaceWeights() {
  const Vec3 ab = start_[1] - start_[0];
  const Vec3 ac = start_[2] - start_[0];
  const Vec3 across = ab.cross(ac);
  const double area = across.squaredNorm();
  constexpr double thin = 1e-12;  // squared sine of the angle between two sides; for slivers all points count
  faceWeights_ = {Vec3::Zero(), Vec3::Zero()};
  if (area > thin * ab.squaredNorm() * ac.squaredNorm()) {
    faceWeights_ = {ac.cross(across) / area, across.cross(ab) / area};
  }
}

/// Whether a point lies over the face. The arithmetic is that of `inRegion`, so that the result for a point on the
/// border does not depend on whether its feature was cached.
bool SharpFeatureSearch::isOverFace(const Vec3& point) const {
  const Vec3 from = point - start_[0];
  const auto along = [&](const Vec3& weights) {
    return weights.x() * from.x() + weights.y() * from.y() + weights.z() * from.z();
  };
  const double second = along(faceWeights_[0]);
  const double third = along(faceWeights_[1]);
  return std::min(second, third) >= 0.0 && second + third <= 1.0;
}

/// Adds contacts of the vertices and edges that are close, and caches those that can be close after a displacement of
/// the triangle by `slack` [m].
void SharpFeatureSearch::searchFeatures(const std::vector<int>& leaves, const BoxList& boxes, double slack,
                                        NearbyFeatures& memory) {
  computeFaceWeights();
  const FaceRegion close = region(slack);
  boxesMeeting(boxes, close.box, leaves_);
  for (std::int32_t& each : leaves_) {
    each = leaves[each];
  }
  mesh_.mesh.featuresIn(close, leaves_, mesh_.atEnd, found_);
  const double far = memory.complete + slack;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    mesh_.mesh.forEachFeature(static_cast<std::size_t>(leaves_[i]), found_[i],
                              [&](const MeshFeature& feature, bool isEdge) {
                                const auto at = static_cast<std::uint8_t>(feature.at);
                                if (isEdge) {
                                  rememberEdge(feature.triangle, at, far, memory);
                                  return;
                                }
                                const double gap = addVertexContact(feature.triangle, at);
                                if (gap < far && memory.validRadius >= 0.0) {
                                  memory.features.push_back({feature.triangle, at, 0, floatBelow(gap)});
                                }
                              });
  }
}

/// Adds the contacts of an edge of the mesh, and caches it with the sides that are near.
void SharpFeatureSearch::rememberEdge(int bodyTriangle, std::uint8_t side, double far, NearbyFeatures& memory) {
  const std::uint8_t sides = sidesNear(bodyTriangle, side, std::max(far, close_));
  unsigned near = 0;
  double minimum = far;
  for (std::size_t k = 0; k < 3; ++k) {
    if ((sides >> k & 1U) == 0) {
      continue;
    }
    const double gap = addEdgeContact(bodyTriangle, side, k);
    if (gap < far) {
      near |= 1U << k;
      minimum = std::min(minimum, gap);
    }
  }
  if (near != 0 && memory.validRadius >= 0.0) {
    memory.features.push_back({bodyTriangle, side, static_cast<std::uint8_t>(near), floatBelow(minimum)});
  }
}

/// Adds a contact if it counts and is close. Returns the distance of the two points [m].
double SharpFeatureSearch::contact(int bodyTriangle, const Corners& at, const Vec3& weights, const Vec3& bodyWeights,
                                   bool counts) {
  const Vec3 offset = pointAt(start_, weights) - pointAt(at, bodyWeights);
  const double gap = offset.norm();
  featureGap_ = std::min(featureGap_, gap);
  if (counts && gap < close_ && gap > 0.0) {
    const NearPoint near{gap, offset / gap, pointAt(mesh_.startCorners(bodyTriangle), bodyWeights),
                         pointAt(mesh_.endCorners(bodyTriangle), bodyWeights)};
    builder_.addContact(cloth_, t_, weights, near, builder_.offsets().edgeOffset, candidates_);
  }
  return gap;
}

/// Returns the distance of the triangle and a vertex of the mesh [m].
double SharpFeatureSearch::addVertexContact(int bodyTriangle, std::size_t corner) {
  const Corners at = mesh_.corners(bodyTriangle);
  const Vec3 weights = nearestOnTriangle(at[corner], start_);
  return contact(bodyTriangle, at, weights, onCorner(corner), isInside(weights) && isOverFace(at[corner]));
}

/// The sides of the triangle whose boxes are within a distance of that of an edge of the mesh, as a bit mask. Only
/// sides that the triangle owns count.
std::uint8_t SharpFeatureSearch::sidesNear(int bodyTriangle, std::size_t side, double far) const {
  const Corners at = mesh_.corners(bodyTriangle);
  const Vec3& from = at[side];
  const Vec3& to = at[(side + 1) % 3];
  const Eigen::AlignedBox3d around(from.cwiseMin(to).array() - far, from.cwiseMax(to).array() + far);
  unsigned near = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = start_[k];
    const Vec3& b = start_[(k + 1) % 3];
    if (cloth_.owned[t_].sides[k] && around.intersects(Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b)))) {
      near |= 1U << k;
    }
  }
  return static_cast<std::uint8_t>(near);
}

/// Returns the distance of a side of the triangle and an edge of the mesh [m].
double SharpFeatureSearch::addEdgeContact(int bodyTriangle, std::size_t side, std::size_t ownSide) {
  const Corners at = mesh_.corners(bodyTriangle);
  const SegmentPair pair =
      nearestOfSegments({start_[ownSide], start_[(ownSide + 1) % 3]}, {at[side], at[(side + 1) % 3]});
  return contact(bodyTriangle, at, onSide(ownSide, pair.first), onSide(side, pair.second),
                 isInside(pair.first) && isInside(pair.second));
}

}  // namespace drape::sim::contact
