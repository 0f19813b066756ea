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

/// Finds the contacts of vertices with meshes (MeshSearch), and all contacts and separating planes of planes, spheres
/// and capsules (PrimitiveSearch).
/// @param frames with the start and the predicted positions, and the displacement bounds
[[nodiscard]] VertexContacts findVertexContacts(const ContactPass& pass, const ClothFrames& frames,
                                                const BodyOverlaps& overlaps);

/// Finds the contacts of edges and faces of the cloth with meshes that the solved positions violate. On surfaces that
/// are smooth at the scale of the cloth there are none, since the contacts of vertices suffice.
/// @param frames with the solved positions
[[nodiscard]] std::vector<ContactConstraint> findSharpFeatureContacts(const ContactPass& pass,
                                                                      const ClothFrames& frames,
                                                                      const BodyOverlaps& overlaps);

}  // namespace drape::sim::contact
