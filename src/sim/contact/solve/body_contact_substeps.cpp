// The part of BodyContact that finds contacts for the substeps of a solver.
#include "sim/contact/solve/body_contact.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double marginRatio = 0.25;    // distance beyond the predicted position within which contacts are listed
constexpr double restGapRatio = 0.002;  // distance within which a vertex rests on the surface

}  // namespace

void BodyContact::findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                                      const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                      const std::vector<Vec3>& start, const std::vector<Vec3>& ahead,
                                      std::vector<SubstepContact>& found) {
  const Cloth cloth{model, parameters, contact, start, ahead};
  const double fall = parameters.gravity * parameters.timeStep * parameters.timeStep;
  nearCount_ = 0;
  if (!chooseBodies(cloth, bodies, ahead, inflated(boundsOf(ahead), fall))) {
    return;
  }
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.overlaps = false;
    near.offsets.separationStep = 0.0;
    near.offsets.listMargin = marginRatio * near.offsets.contactOffset + fall;
    if (near.mesh != nullptr) {
      clustersOf(model);  // updates models_
      near.meshSearch.begin(*near.mesh, models_);
    }
  }
  prepareBodyFrames(cloth, nullptr);
  for (double& bound : displacementBounds_) {
    bound += fall + marginRatio * maxContactOffset();
  }
  searchVertexContacts(cloth, false);
  if (hasMeshes()) {
    transformSolved(cloth, ahead);
    searchSharpFeatures(cloth, false);
  }
  for (const ContactConstraint& each : candidates_.contacts) {
    addSubstepContact(cloth, each, found);
  }
}

void BodyContact::addSubstepContact(const Cloth& cloth, const ContactConstraint& contact,
                                    std::vector<SubstepContact>& found) {
  const NearBody& near = near_[contact.body];
  const auto largest = std::max_element(contact.weights.begin(), contact.weights.end());
  const auto first = static_cast<std::size_t>(largest - contact.weights.begin());
  const bool isVertex = *largest == 1.0;
  if (contact.offset <= 0.0 || (isVertex && near.mesh != nullptr &&
                                near.meshSearch.isBehindFace(near.meshInStep(false), contact.vertices[first]))) {
    return;
  }
  SubstepContact own{.vertices = contact.vertices,
                     .weights = contact.weights,
                     .normal = contact.normal,
                     .height = contact.height - contact.normal.dot(contact.bodyDisplacement) + contact.offset,
                     .restGap = restGapRatio * near.offsets.contactOffset,
                     .bodyVelocity = contact.bodyDisplacement / cloth.parameters.timeStep,
                     .staticFriction = contact.staticFriction,
                     .kineticFriction = contact.kineticFriction};
  if (isVertex) {
    std::swap(own.vertices[0], own.vertices[first]);
    own.weights = {1.0, 0.0, 0.0, 0.0};
  }
  found.push_back(own);
}

void BodyContact::reportSubstepContacts(const std::vector<SubstepContact>& contacts, const ClothState& state,
                                        ContactReport& report, std::vector<ContactPoint>& points) const {
  std::vector<bool> reported(state.positions.size());
  for (const ContactConstraint& contact : active_) {
    for (std::size_t c = 0; c < contact.vertices.size(); ++c) {
      if (contact.weights[c] == 1.0) {
        reported[contact.vertices[c]] = true;
      }
    }
  }
  for (const SubstepContact& contact : contacts) {
    if (contact.isWithBody() && contact.isVertex() && !contact.impulse.isZero(0.0) && !reported[contact.vertices[0]]) {
      ++report.bodyContacts;
      points.push_back({state.positions[contact.vertices[0]], contact.normal});
    }
  }
}

}  // namespace drape::sim::contact
