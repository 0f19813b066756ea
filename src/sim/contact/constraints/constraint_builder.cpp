#include "sim/contact/constraints/constraint_builder.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <algorithm>

namespace drape::sim::contact {

double ContactOffsets::recoveryStepAt(double depth) const {
  constexpr double referenceDepth = 0.125;  // depth at which the step doubles [m]
  return recoveryStep * std::min(4.0, 1.0 + depth / referenceDepth);
}

void ConstraintBuilder::addContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const NearPoint& near,
                                   double wanted, Candidates& candidates) const {
  const double separationStep =
      near.gap < 0.0 ? offsets_.recoveryStepAt(std::max(near.depth, -near.gap)) : offsets_.separationStep;
  const double offset = std::min(wanted, near.gap + separationStep);
  const double height = near.normal.dot(near.endPoint);
  const Vec3 predicted = pointAt(cornersOf(cloth.predicted, cloth.triangles[t]), weights);
  const double gap = near.normal.dot(predicted) - height;
  const double nearest = offsets_.listMargin > 0.0 ? std::min(near.gap, gap) : gap;
  if (nearest >= offset + offsets_.listMargin) {
    return;
  }
  ContactConstraint contact;
  const auto& [a, b, c] = cloth.triangles[t];
  contact.vertices = {a, b, c, c};
  contact.weights = {weights[0], weights[1], weights[2], 0.0};
  contact.normal = step_.end.rotation * near.normal;
  contact.height = height + contact.normal.dot(step_.end.position);
  contact.offset = offset;
  contact.bodyDisplacement = step_.end.toWorld(near.endPoint) - step_.start.toWorld(near.startPoint);
  contact.staticFriction = friction_ * step_.surface.staticFriction;
  contact.kineticFriction = friction_ * std::min(step_.surface.kineticFriction, step_.surface.staticFriction);
  contact.body = index_;
  candidates.contacts.push_back(contact);
}

void ConstraintBuilder::addPlanes(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height,
                                  double gap, Candidates& candidates) const {
  // Cloth that is already closer than the minimum separation must not come closer still.
  const double limit = height + std::min(offsets_.minimumSeparation, gap);
  const Vec3 world = step_.end.rotation * normal;
  const double origin = world.dot(step_.end.position);
  for (const int v : cloth.triangles[t]) {
    if (normal.dot(vectorAt(cloth.start, v)) - cloth.displacementBounds[v] < limit) {
      candidates.planes.push_back({v, index_, world, limit + origin});
    }
  }
}

void ConstraintBuilder::addPlane(int vertex, const Vec3& normal, double height, double gap,
                                 Candidates& candidates) const {
  const Vec3 world = step_.end.rotation * normal;
  candidates.planes.push_back(
      {vertex, index_, world, height + std::min(offsets_.minimumSeparation, gap) + world.dot(step_.end.position)});
}

}  // namespace drape::sim::contact
