// Decides whether BodyContact makes another pass.
#include "sim/contact/solve/body_contact.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double maxMoveRatio = 0.25;      // maximum displacement of vertices
constexpr double maxGapErrorRatio = 0.05;  // maximum difference between the true gap and that of the contact

}  // namespace

/// Whether planes moved vertices far, or impulses moved them so far that the gap of a contact no longer is the distance
/// to the body.
bool BodyContact::needsAnotherPass(const Cloth& cloth, const std::vector<Vec3>* previous,
                                   const std::vector<Vec3>& positions) const {
  const double far = maxMoveRatio * maxContactOffset();
  if (filter_.maxCorrection() > far) {
    return true;
  }
  return std::any_of(candidates_.contacts.begin(), candidates_.contacts.end(), [&](const ContactConstraint& contact) {
    const bool stays = std::all_of(contact.vertices.begin(), contact.vertices.end(), [&](int vertex) {
      return (positions[vertex] -
              (previous != nullptr ? (*previous)[vertex] : Vec3(cloth.start[vertex] + contact.bodyDisplacement)))
                 .norm() <= far;
    });
    if (stays) {
      return false;
    }
    const NearBody& near = near_[contact.body];
    const Vec3 position = pointOf(contact, positions);
    const double gap = contact.normal.dot(position) - contact.height;
    const double tolerance = maxGapErrorRatio * near.offsets.contactOffset;
    return near.overlaps || gap <= tolerance ||
           std::abs(gapTo(near, near.step->end.toLocal(position), gap + tolerance) - gap) > tolerance;
  });
}

/// Distance of a position in a body's frame to the body at the end of the step [m]. On meshes infinite beyond `maxGap`.
double BodyContact::gapTo(const NearBody& near, const Vec3& position, double maxGap) const {
  if (near.mesh == nullptr) {
    return PrimitiveSearch(*near.step, 0, near.offsets).gapAt(position);
  }
  const MeshInStep mesh = near.meshInStep(true);
  return NearestSearch(mesh).anywhere(position, maxGap).gap;
}

}  // namespace drape::sim::contact
