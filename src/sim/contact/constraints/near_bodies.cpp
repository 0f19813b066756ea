#include "sim/contact/constraints/near_bodies.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double edgeOffsetRatio = 0.6;         // distance of edges and faces
constexpr double minimumSeparationRatio = 0.1;  // minimum separation
/// Recovery speed of shallow cloth [m/s]; up to four times as fast where it is deep (ContactOffsets::recoveryStepAt).
constexpr double recoverySpeed = 0.25;

}  // namespace

MeshInStep NearBody::meshInStep(bool atEnd) const {
  const std::span<const Vec3> own = mesh->shape.positions;
  const bool moves = mesh->isDeforming();
  return {*mesh, moves ? step->startVertices : own, moves ? step->endVertices : own, atEnd};
}

void NearBodies::add(const std::vector<ReachableBody>& found, const ClothStep& step) {
  for (const ReachableBody& each : found) {
    const double offset = contactOffsetOf(*each.step, step.contact);
    const double recoveryStep = recoverySpeed * step.parameters.timeStep;
    const ContactOffsets offsets{offset, edgeOffsetRatio * offset, minimumSeparationRatio * offset, recoveryStep,
                                 recoveryStep};
    MeshSearch* search = each.mesh != nullptr ? &searches_[each.step->body] : nullptr;
    bodies_.push_back(
        {each.step, static_cast<int>(bodies_.size()), each.mesh, search, offsets, step.contact.bodyFriction});
  }
}

void NearBodies::beginPass(const PreparedCloth& cloth) {
  for (NearBody& body : bodies_) {
    if (body.mesh != nullptr) {
      body.search->begin(*body.mesh, cloth.number);
    }
  }
}

std::vector<const BodyStep*> NearBodies::steps() const {
  std::vector<const BodyStep*> steps(bodies_.size());
  std::transform(bodies_.begin(), bodies_.end(), steps.begin(), [](const NearBody& body) { return body.step; });
  return steps;
}

bool NearBodies::haveMeshes() const {
  return std::any_of(bodies_.begin(), bodies_.end(), [](const NearBody& body) { return body.mesh != nullptr; });
}

double NearBodies::maxContactOffset() const {
  double offset = 0.0;
  for (const NearBody& body : bodies_) {
    offset = std::max(offset, body.offsets.contactOffset);
  }
  return offset;
}

}  // namespace drape::sim::contact
