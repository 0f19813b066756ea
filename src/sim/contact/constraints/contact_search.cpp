#include "sim/contact/constraints/contact_search.hpp"

#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/contact/constraints/primitive_search.hpp"

#include <utility>
#include <variant>

namespace drape::sim::contact {
namespace {

void searchPrimitive(const ContactPass& pass, const ClothInBody& cloth, const PrimitiveSearch& search,
                     Candidates& candidates) {
  const int threads = pass.step.parameters.threads;
  const std::size_t count = pass.step.model.triangles.size();
  if (threads <= 1) {
    search.search(cloth, 0, count, candidates);
    return;
  }
  const auto parts = collectInOrder<Candidates>(
      pass.workers, threads, static_cast<int>(count), [&](int begin, int end, Candidates& part) {
        search.search(cloth, static_cast<std::size_t>(begin), static_cast<std::size_t>(end), part);
      });
  for (const Candidates& part : parts) {
    candidates.append(part);
  }
}

}  // namespace

VertexContacts findVertexContacts(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps) {
  VertexContacts found;
  for (const NearBody& body : pass.bodies) {
    ContactOffsets offsets = body.offsets;
    offsets.recoveryStep = pass.atEnd() ? 0.0 : offsets.recoveryStep;
    const ClothInBody cloth = frames.predictedIn(body, pass, overlaps.in(body));
    if (body.mesh != nullptr) {
      body.search->findVertexContacts(ConstraintBuilder(*body.step, body.index, offsets, body.friction),
                                      body.meshInStep(pass.atEnd()), cloth, pass.cloth.clusters, pass.workers,
                                      pass.step.parameters.threads, found.candidates);
      continue;
    }
    const int before = found.candidates.overlaps;
    searchPrimitive(pass, cloth, PrimitiveSearch(*body.step, body.index, offsets, body.friction), found.candidates);
    if (found.candidates.overlaps > before && !std::holds_alternative<PlaneShape>(body.step->body->shape)) {
      found.entered.push_back(body.index);
    }
  }
  return found;
}

std::vector<ContactConstraint> findSharpFeatureContacts(const ContactPass& pass, const ClothFrames& frames,
                                                        const BodyOverlaps& overlaps) {
  Candidates found;
  for (const NearBody& body : pass.bodies) {
    if (body.mesh != nullptr) {
      body.search->findSharpFeatureContacts(body.builder(), body.meshInStep(pass.atEnd()),
                                            frames.solvedIn(body, pass, overlaps.in(body)), pass.cloth.clusters,
                                            pass.workers, pass.step.parameters.threads, found);
    }
  }
  return std::move(found.contacts);
}

}  // namespace drape::sim::contact
