#pragma once

#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/recovery/body_overlaps.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Whether another pass must follow: planes moved vertices far, or impulses moved them so far that the gap along the
/// normal of a contact is no longer the distance to the body.
/// @param contacts of the pass  @param maxCorrection maximum displacement of a vertex by planes [m]
/// @param positions the result of the pass [m]
[[nodiscard]] bool needsAnotherPass(const ContactPass& pass, std::span<const ContactConstraint> contacts,
                                    const BodyOverlaps& overlaps, double maxCorrection,
                                    const std::vector<Vec3>& positions);

}  // namespace drape::sim::contact
