#pragma once

#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/contact_report.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_state.hpp"

#include <optional>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// Distance beyond the predicted position within which contacts are listed for the substeps of a solver [m].
/// @param fall distance that gravity can add to the prediction [m]
[[nodiscard]] double listMarginOf(double contactOffset, double fall);

/// Converts a contact into one for the substeps of a solver (SubstepContact), which moves with the body; empty for
/// vertices that may be inside a body, since they must leave it.
/// @param timeStep length of the contact substep [s]
[[nodiscard]] std::optional<SubstepContact> substepContactOf(const ContactConstraint& contact, const NearBody& body,
                                                             double timeStep);

/// Reports contacts of vertices with bodies that acted in the substeps, except those of vertices with active contacts.
/// @param active contacts at the end of the contact substep  @param contacts of its substeps, with their impulses
/// @param report the number is added  @param points the contacts are appended
void reportSubstepContacts(std::span<const ContactConstraint> active, std::span<const SubstepContact> contacts,
                           const ClothState& state, ContactReport& report, std::vector<ContactPoint>& points);

}  // namespace drape::sim::contact
