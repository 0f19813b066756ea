#include "sim/contact/solve/convergence.hpp"

#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/constraints/primitive_search.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double maxMoveRatio = 0.25;      // displacement of a vertex that needs no further pass
constexpr double maxGapErrorRatio = 0.05;  // allowed difference between the distance to the body and the contact's gap

/// Distance of a position in a body's frame to the body at the end of the step [m]; to a mesh infinite beyond `maxGap`.
double gapTo(const NearBody& body, const Vec3& position, double maxGap) {
  if (body.mesh == nullptr) {
    return PrimitiveSearch(*body.step, 0, body.offsets).gapAt(position);
  }
  const MeshInStep mesh = body.meshInStep(true);
  return NearestSearch(mesh).anywhere(position, maxGap).gap;
}

}  // namespace

bool needsAnotherPass(const ContactPass& pass, std::span<const ContactConstraint> contacts,
                      const BodyOverlaps& overlaps, double maxCorrection, const std::vector<Vec3>& positions) {
  if (contacts.empty()) {
    return maxCorrection > 0.0;
  }
  const double far = maxMoveRatio * pass.bodies.maxContactOffset();
  if (maxCorrection > far) {
    return true;
  }
  return std::any_of(contacts.begin(), contacts.end(), [&](const ContactConstraint& contact) {
    const bool stays = std::all_of(contact.vertices.begin(), contact.vertices.end(), [&](int vertex) {
      return (positions[vertex] -
              (pass.atEnd() ? (*pass.previous)[vertex] : Vec3(pass.step.start[vertex] + contact.bodyDisplacement)))
                 .norm() <= far;
    });
    if (stays) {
      return false;
    }
    const NearBody& body = pass.bodies[contact.body];
    const Vec3 position = pointOf(contact, positions);
    const double gap = contact.normal.dot(position) - contact.height;
    const double tolerance = maxGapErrorRatio * body.offsets.contactOffset;
    return overlaps.in(body) != nullptr || gap <= tolerance ||
           std::abs(gapTo(body, body.step->end.toLocal(position), gap + tolerance) - gap) > tolerance;
  });
}

}  // namespace drape::sim::contact
