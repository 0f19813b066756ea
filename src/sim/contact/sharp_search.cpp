#include "sim/contact/sharp_search.hpp"

#include <algorithm>
#include <bit>

namespace drape {

/// Measures a triangle and what is near it along its normal; false where nothing is near.
bool SharpSearch::place(int t, const std::vector<int>& patches, const BoxList& boxes) {
  t_ = static_cast<std::size_t>(t);
  base_ = cornersOf(cloth_.base, cloth_.triangles[t_]);
  boxesMeeting(boxes, inflated(boxAround(base_), near_), patches_);
  if (patches_.empty()) {
    return false;
  }
  for (std::int32_t& each : patches_) {
    each = patches[static_cast<std::size_t>(each)];
  }
  normal_ = faceNormal(base_);
  own_ = {lowestAlong(normal_, base_), highestAlong(normal_, base_)};
  all_ = mesh_.mesh.extentsAlong(normal_, patches_, mesh_.settled, extents_);
  return true;
}

OwnPlane SharpSearch::plane() const {
  const bool above = own_.low - all_.high >= all_.low - own_.high;
  return above ? OwnPlane{normal_, all_.high} : OwnPlane{-normal_, -all_.low};
}

OwnPlane SharpSearch::planeOf(int t, const std::vector<int>& patches, const BoxList& boxes) {
  return place(t, patches, boxes) ? plane() : OwnPlane();
}

OwnPlane SharpSearch::look(int t, const std::vector<int>& patches, const BoxList& boxes) {
  if (!place(t, patches, boxes)) {
    return {};
  }
  if (own_.low - all_.high < close_ && all_.low - own_.high < close_) {
    around_ = inflated(boxAround(base_), close_);
    low_ = own_.low - close_;
    high_ = own_.high + close_;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (extents_[i].high > low_ && extents_[i].low < high_) {
        lookInto(static_cast<std::size_t>(patches_[i]));
      }
    }
  }
  return plane();
}

double SharpSearch::distanceAtLeast(const OwnPlane& plane, std::span<const NearVertex> nearest) {
  if (patches_.empty()) {
    return near_;
  }
  double widest = lowestAlong(plane.normal, base_) - plane.top;
  for (const int v : cloth_.triangles[t_]) {
    const NearVertex& near = nearest[static_cast<std::size_t>(v)];
    if (widest < close_ && near.triangle >= 0) {
      const Extent all = mesh_.mesh.extentsAlong(near.normal, patches_, mesh_.settled, extents_);
      widest = std::max(widest, lowestAlong(near.normal, base_) - all.high);
    }
  }
  return std::min(widest, near_);
}

void SharpSearch::lookInto(std::size_t patch) {
  if (!mesh_.mesh.tree.leafBox(patch).intersects(around_)) {
    return;
  }
  const std::span<const int> triangles = mesh_.mesh.tree.leaf(patch);
  std::uint32_t close = mesh_.mesh.trianglesBetween(normal_, low_, high_, patch, mesh_.settled);
  for (; close != 0; close &= close - 1) {
    const int triangle = triangles[static_cast<std::size_t>(std::countr_zero(close))];
    const Corners at = mesh_.base(triangle);
    if (boxAround(at).intersects(around_)) {
      touchVertices(triangle, at);
      touchEdges(triangle, at);
    }
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

void SharpSearch::touchVertices(int bodyTriangle, const Corners& at) {
  for (std::size_t k = 0; k < 3; ++k) {
    const bool close = mesh_.mesh.owned[static_cast<std::size_t>(bodyTriangle)].corners[k] && around_.contains(at[k]);
    if (!close) {
      continue;
    }
    const Vec3 weights = nearestOnTriangle(at[k], base_);
    if (isInside(weights)) {
      touch(bodyTriangle, at, weights, onCorner(k));
    }
  }
}

void SharpSearch::touchEdges(int bodyTriangle, const Corners& at) {
  const auto b = static_cast<std::size_t>(bodyTriangle);
  for (std::size_t m = 0; m < 3; ++m) {
    if (!mesh_.mesh.owned[b].sides[m] || !mesh_.mesh.sharp[b][m]) {
      continue;
    }
    const Vec3& from = at[m];
    const Vec3& to = at[(m + 1) % 3];
    const double fromHeight = normal_.dot(from);
    const double toHeight = normal_.dot(to);
    if (std::max(fromHeight, toHeight) <= low_ || std::min(fromHeight, toHeight) >= high_) {
      continue;
    }
    const Eigen::AlignedBox3d around(from.cwiseMin(to).array() - close_, from.cwiseMax(to).array() + close_);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = base_[k];
      const Vec3& b2 = base_[(k + 1) % 3];
      if (!cloth_.owned[t_].sides[k] || !around.intersects(Eigen::AlignedBox3d(a.cwiseMin(b2), a.cwiseMax(b2)))) {
        continue;
      }
      const SegmentPair pair = nearestOfSegments({a, b2}, {from, to});
      if (isInside(pair.first) && isInside(pair.second)) {
        touch(bodyTriangle, at, onSide(k, pair.first), onSide(m, pair.second));
      }
    }
  }
}

}  // namespace drape
