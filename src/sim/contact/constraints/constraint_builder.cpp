#include "sim/contact/constraints/constraint_builder.hpp"

#include <algorithm>

namespace drape {

Vec3 onCorner(std::size_t k) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0;
  return weights;
}

Vec3 onSide(std::size_t k, double along) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0 - along;
  weights[static_cast<Eigen::Index>((k + 1) % 3)] = along;
  return weights;
}

double ContactReach::freedFrom(double depth) const {
  constexpr double deep = 0.125;  // [m]
  return free * std::min(4.0, 1.0 + depth / deep);
}

Vec3 pointOf(const Touch& touch, const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    sum += touch.weights[static_cast<Eigen::Index>(c)] * values[static_cast<std::size_t>(touch.vertices[c])];
  }
  return sum;
}

void Findings::append(const Findings& more) {
  touches.insert(touches.end(), more.touches.begin(), more.touches.end());
  barriers.insert(barriers.end(), more.barriers.begin(), more.barriers.end());
  overlaps += more.overlaps;
  deepestOverlap = std::max(deepestOverlap, more.deepestOverlap);
}

void BodySide::addTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const NearPoint& near,
                        double wanted, Findings& findings) const {
  const double push = near.gap < 0.0 ? reach_.freedFrom(std::max(near.depth, -near.gap)) : reach_.push;
  const double keep = std::min(wanted, near.gap + push);
  const double height = near.normal.dot(near.endPoint);
  const Vec3 target = pointAt(cornersOf(cloth.target, cloth.triangles[t]), weights);
  if (near.normal.dot(target) - height >= keep) {
    return;
  }
  Touch touch;
  touch.vertices = cloth.triangles[t];
  touch.weights = weights;
  touch.normal = step_.end.rotation * near.normal;
  touch.height = height + touch.normal.dot(step_.end.position);
  touch.keep = keep;
  touch.bodyMove = step_.end.toWorld(near.endPoint) - step_.start.toWorld(near.startPoint);
  touch.staticFriction = step_.surface.staticFriction;
  touch.kineticFriction = std::min(step_.surface.kineticFriction, step_.surface.staticFriction);
  touch.body = index_;
  findings.touches.push_back(touch);
}

void BodySide::addBarriers(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                           Findings& findings) const {
  const double guarded = height + std::min(reach_.guard, gap);  // what is nearer than the guard comes no nearer
  const Vec3 world = step_.end.rotation * normal;
  const double origin = world.dot(step_.end.position);
  for (const int v : cloth.triangles[t]) {
    if (normal.dot(vectorAt(cloth.base, v)) - cloth.room[static_cast<std::size_t>(v)] < guarded) {
      findings.barriers.push_back({v, index_, world, guarded + origin});
    }
  }
}

void BodySide::addBarrier(int vertex, const Vec3& normal, double height, double gap, Findings& findings) const {
  const Vec3 world = step_.end.rotation * normal;
  findings.barriers.push_back(
      {vertex, index_, world, height + std::min(reach_.guard, gap) + world.dot(step_.end.position)});
}

}  // namespace drape
