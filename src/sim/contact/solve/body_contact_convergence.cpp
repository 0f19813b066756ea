// When contact looks at the cloth again in a step: BodyContact::leftItsTouches.
#include "sim/contact/solve/body_contact.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

// Of the distance that is kept [-]:
constexpr double maxMoveRatio = 0.25;      // how far something may be moved before its contacts are looked at again
constexpr double maxGapErrorRatio = 0.05;  // by how much a body may lie elsewhere then than the contact has it

}  // namespace

/// Whether something was moved far by planes, or so far by contacts that where it is now a body is not where its
/// contact has it.
bool BodyContact::needsAnotherPass(const Cloth& cloth, const std::vector<Vec3>* safe,
                                   const std::vector<Vec3>& positions) const {
  const double far = maxMoveRatio * maxContactOffset();
  if (filter_.maxCorrection() > far) {
    return true;
  }
  return std::any_of(found_.contacts.begin(), found_.contacts.end(), [&](const ContactConstraint& contact) {
    const bool stays = std::all_of(contact.vertices.begin(), contact.vertices.end(), [&](int vertex) {
      const auto v = static_cast<std::size_t>(vertex);
      return (positions[v] - (safe != nullptr ? (*safe)[v] : Vec3(cloth.start[v] + contact.bodyDisplacement))).norm() <=
             far;
    });
    if (stays) {
      return false;
    }
    const NearBody& near = near_[static_cast<std::size_t>(contact.body)];
    const Vec3 prepareBodyFrames = pointOf(contact, positions);
    const double above = contact.normal.dot(prepareBodyFrames) - contact.height;
    const double within = maxGapErrorRatio * near.offsets.contactOffset;
    return near.overlaps || above <= within ||
           std::abs(gapTo(near, near.step->end.toLocal(prepareBodyFrames), above + within) - above) > within;
  });
}

/// From a place in a body's frame to the body, at the end of the step [m]; infinite where it is more than `most`.
double BodyContact::gapTo(const NearBody& near, const Vec3& prepareBodyFrames, double maximum) const {
  if (near.mesh == nullptr) {
    return PrimitiveSearch(*near.step, 0, near.offsets).gapAt(prepareBodyFrames);
  }
  const MeshInStep mesh = near.meshInStep(true);
  return NearestSearch(mesh).anywhere(prepareBodyFrames, maximum).gap;
}

}  // namespace drape
