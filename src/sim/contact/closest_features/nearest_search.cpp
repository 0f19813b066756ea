#include "sim/contact/closest_features/nearest_search.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

/// What rounding makes of squared distances that are equal, and more [-].
constexpr double roundedUp = 1.0 + 1e-12;
constexpr float roundedDown = 1.0F - 1e-6F;  // the same of distances as floats [-]

}  // namespace

void NearestSearch::lookAt(int triangle, const Vec3& point) {
  const Triangle& corners = mesh_.mesh.shape.triangles[static_cast<std::size_t>(triangle)];
  const Vec3& a = vectorAt(mesh_.atBase(), corners[0]);
  const Vec3& b = vectorAt(mesh_.atBase(), corners[1]);
  const Vec3& c = vectorAt(mesh_.atBase(), corners[2]);
  const Vec3 weights = quickNearestOnTriangle(point, a, b, c);
  const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - point).squaredNorm();
  if (distance < least_ || (distance == least_ && triangle < best_.triangle)) {
    least_ = distance;
    best_.triangle = triangle;
    best_.weights = weights;
  }
}

NearVertex NearestSearch::result(const Vec3& point) {
  if (best_.triangle >= 0) {
    const Vec3 way = point - pointAt(mesh_.base(best_.triangle), best_.weights);
    best_.gap = way.norm();
    best_.normal = best_.gap > 0.0 ? Vec3(way / best_.gap) : Vec3(Vec3::UnitY());
  }
  return best_;
}

int NearestSearch::triangleAt(std::size_t box) const {
  return mesh_.mesh.tree.leaf(static_cast<std::size_t>(near_[box / trianglesOfPatch]))[box % trianglesOfPatch];
}

void NearestSearch::remember(const Vec3& point, double within, double beyond, NearbyTriangles& memory) const {
  memory.at = point;
  memory.serves = -1.0;
  memory.count = 0;
  if (best_.triangle < 0) {
    const auto nearest = std::min_element(toPatch_.begin(), toPatch_.end());
    memory.clear = nearest == toPatch_.end() ? beyond : std::min(beyond, std::sqrt(*nearest));
    return;
  }
  memory.clear = std::sqrt(least_);
  // What is nearest elsewhere is no farther from there than the triangle that is nearest here.
  const double far = memory.clear + 2.0 * within;
  for (std::size_t i = 0; i < toBox_.size(); ++i) {
    if (toBox_[i] <= roundedUp * far * far) {
      if (memory.count == NearbyTriangles::most) {
        return;
      }
      memory.triangles[memory.count] = triangleAt(i);
      memory.toBox[memory.count] = roundedDown * static_cast<float>(std::sqrt(toBox_[i]));
      if (memory.triangles[memory.count] == best_.triangle) {  // it comes first: that bounds what others can be
        std::swap(memory.triangles[memory.count], memory.triangles[0]);
        std::swap(memory.toBox[memory.count], memory.toBox[0]);
      }
      ++memory.count;
    }
  }
  memory.serves = within;
}

NearVertex NearestSearch::amongRemembered(const NearbyTriangles& memory, const Vec3& point, double radius,
                                          double moved) {
  best_ = {};
  least_ = radius * radius;
  for (std::size_t i = 0; i < memory.count; ++i) {
    const double toBox = static_cast<double>(memory.toBox[i]) - moved;
    if (toBox <= 0.0 || toBox * toBox <= roundedUp * least_) {
      lookAt(memory.triangles[i], point);
    }
  }
  return result(point);
}

NearVertex NearestSearch::among(const std::vector<int>& patches, const BoxList& boxes, const Vec3& point, double radius,
                                double within) {
  best_ = {};
  least_ = radius * radius;
  squaredDistances(boxes, point, toPatch_);
  const double far = radius + 2.0 * within;
  near_.clear();
  for (std::size_t i = 0; i < toPatch_.size(); ++i) {
    if (toPatch_[i] <= roundedUp * far * far) {
      near_.push_back(patches[i]);
    }
  }
  squaredDistances(mesh_.mesh.triangleBoxes(mesh_.settled), near_, point, toBox_);
  const auto first = static_cast<std::size_t>(std::min_element(toBox_.begin(), toBox_.end()) - toBox_.begin());
  if (near_.empty() || !(toBox_[first] < least_)) {
    return best_;
  }
  lookAt(triangleAt(first), point);
  for (std::size_t i = 0; i < toBox_.size(); ++i) {
    if (toBox_[i] <= roundedUp * least_ && i != first) {
      lookAt(triangleAt(i), point);
    }
  }
  return result(point);
}

NearVertex NearestSearch::anywhere(const Vec3& point, double radius) {
  best_ = {};
  least_ = radius * radius;
  double limit = roundedUp * least_;  // what is as near counts too: it may come first
  mesh_.mesh.tree.forEachLeafWithin(point, limit, [&](std::size_t leaf) {
    for (const int triangle : mesh_.mesh.tree.leaf(leaf)) {
      lookAt(triangle, point);
    }
    limit = roundedUp * least_;
  });
  return result(point);
}

}  // namespace drape
