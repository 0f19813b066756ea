#pragma once

#include "sim/contact/constraints/cloth_frames.hpp"
#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/recovery/body_overlaps.hpp"

#include <vector>

namespace drape::sim::contact {

/// The result of the first search for contacts.
struct VertexContacts {
  Candidates candidates;
  std::vector<int> entered;  ///< indices of the spheres and capsules with cloth inside
};

/// Finds contacts: on meshes those of vertices; on planes, spheres and capsules all of them, and separating planes.
[[nodiscard]] VertexContacts findVertexContacts(const ContactPass& pass, const ClothFrames& frames,
                                                const BodyOverlaps& overlaps);

/// Finds contacts of edges and faces with meshes that remain when the contacts of vertices are satisfied. On surfaces
/// that are smooth at the scale of the cloth there are none.
/// @param frames with the solved positions
[[nodiscard]] std::vector<ContactConstraint> findSharpFeatureContacts(const ContactPass& pass,
                                                                      const ClothFrames& frames,
                                                                      const BodyOverlaps& overlaps);

}  // namespace drape::sim::contact
