#include "sim/contact/closest_features/nearest_search.hpp"

#include "sim/contact/closest_features/closest_points.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

/// Factor that exceeds the relative rounding error of squared distances [-].
constexpr double roundedUp = 1.0 + 1e-12;
constexpr float roundedDown = 1.0F - 1e-6F;  // the same for distances as float [-]

}  // namespace

void NearestSearch::testTriangle(int triangle, const Vec3& point) {
  const Triangle& corners = mesh_.mesh.shape.triangles[triangle];
  const Vec3& a = vectorAt(mesh_.positions(), corners[0]);
  const Vec3& b = vectorAt(mesh_.positions(), corners[1]);
  const Vec3& c = vectorAt(mesh_.positions(), corners[2]);
  const Vec3 weights = quickNearestOnTriangle(point, a, b, c);
  const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - point).squaredNorm();
  if (distance < minSquaredDistance_ || (distance == minSquaredDistance_ && triangle < best_.triangle)) {
    minSquaredDistance_ = distance;
    best_.triangle = triangle;
    best_.weights = weights;
    best_.squaredDistance = distance;
  }
}

double NearestSearch::squaredDistanceTo(int triangle, const Vec3& point) const {
  const Corners corners = mesh_.corners(triangle);
  return (pointAt(corners, quickNearestOnTriangle(point, corners[0], corners[1], corners[2])) - point).squaredNorm();
}

NearestMeshPoint NearestSearch::result(const Vec3& point) {
  if (best_.triangle >= 0) {
    const Vec3 offset = point - pointAt(mesh_.corners(best_.triangle), best_.weights);
    best_.gap = offset.norm();
    best_.normal = best_.gap > 0.0 ? Vec3(offset / best_.gap) : Vec3(Vec3::UnitY());
  }
  return best_;
}

int NearestSearch::triangleAt(std::size_t box) const {
  return mesh_.mesh.tree.leaf(static_cast<std::size_t>(near_[box / trianglesPerLeaf]))[box % trianglesPerLeaf];
}

void NearestSearch::remember(const Vec3& point, double within, double beyond, NearbyTriangles& memory) const {
  memory.at = point;
  memory.validRadius = -1.0;
  memory.count = 0;
  if (best_.triangle < 0) {
    const auto nearest = std::min_element(toLeaf_.begin(), toLeaf_.end());
    const double toLeaf = nearest == toLeaf_.end() ? beyond : std::min(beyond, std::sqrt(*nearest));
    // Nothing is within the searched radius.
    memory.clearRadius = std::max(toLeaf, std::min(beyond, std::sqrt(minSquaredDistance_)));
    return;
  }
  memory.clearRadius = std::sqrt(minSquaredDistance_);
  // After a displacement of `within`, only triangles within the present distance plus twice that can be closest.
  const double far = memory.clearRadius + 2.0 * within;
  for (std::size_t i = 0; i < toBox_.size(); ++i) {
    if (toBox_[i] > roundedUp * far * far) {
      continue;
    }
    const double squared = squaredDistanceTo(triangleAt(i), point);
    if (squared <= roundedUp * far * far) {
      if (memory.count == NearbyTriangles::capacity) {
        return;
      }
      memory.triangles[memory.count] = triangleAt(i);
      memory.distances[memory.count] = roundedDown * static_cast<float>(std::sqrt(squared));
      if (memory.triangles[memory.count] == best_.triangle) {  // first, since its distance bounds the others
        std::swap(memory.triangles[memory.count], memory.triangles[0]);
        std::swap(memory.distances[memory.count], memory.distances[0]);
      }
      ++memory.count;
    }
  }
  memory.validRadius = within;
}

NearestMeshPoint NearestSearch::amongRemembered(const NearbyTriangles& memory, const Vec3& point, double radius,
                                                double moved) {
  best_ = {};
  minSquaredDistance_ = radius * radius;
  for (std::size_t i = 0; i < memory.count; ++i) {
    const double atLeast = static_cast<double>(memory.distances[i]) - moved;
    if (atLeast <= 0.0 || atLeast * atLeast <= roundedUp * minSquaredDistance_) {
      testTriangle(memory.triangles[i], point);
    }
  }
  return result(point);
}

NearestMeshPoint NearestSearch::among(const std::vector<int>& leaves, const BoxList& boxes, const Vec3& point,
                                      double radius, double within) {
  best_ = {};
  minSquaredDistance_ = radius * radius;
  squaredDistances(boxes, point, toLeaf_);
  const double far = radius + 2.0 * within;
  near_.clear();
  for (std::size_t i = 0; i < toLeaf_.size(); ++i) {
    if (toLeaf_[i] <= roundedUp * far * far) {
      near_.push_back(leaves[i]);
    }
  }
  squaredDistances(mesh_.mesh.triangleBoxes(mesh_.atEnd), near_, point, toBox_);
  const auto first = static_cast<std::size_t>(std::min_element(toBox_.begin(), toBox_.end()) - toBox_.begin());
  if (near_.empty() || !(toBox_[first] < minSquaredDistance_)) {
    return best_;
  }
  testTriangle(triangleAt(first), point);
  for (std::size_t i = 0; i < toBox_.size(); ++i) {
    if (toBox_[i] <= roundedUp * minSquaredDistance_ && i != first) {
      testTriangle(triangleAt(i), point);
    }
  }
  return result(point);
}

NearestMeshPoint NearestSearch::anywhere(const Vec3& point, double radius) {
  best_ = {};
  minSquaredDistance_ = radius * radius;
  double limit = roundedUp * minSquaredDistance_;  // includes equal distances, since the first triangle counts
  mesh_.mesh.tree.forEachLeafWithin(point, limit, [&](std::size_t leaf) {
    for (const int triangle : mesh_.mesh.tree.leaf(leaf)) {
      testTriangle(triangle, point);
    }
    limit = roundedUp * minSquaredDistance_;
  });
  return result(point);
}

}  // namespace drape::sim::contact
