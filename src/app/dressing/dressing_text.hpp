#pragma once

#include "dressing/dressing.hpp"

#include <string>
#include <vector>

namespace drape::app {

/// "the right arm passes through the sleeve's wall (35 pairs of triangles)".
[[nodiscard]] std::string inWords(const dressing::Fault& fault);

/// All of them in one sentence, without a full stop; empty if there are none.
[[nodiscard]] std::string inWords(const std::vector<dressing::Fault>& faults);

/// "12 pairs of triangles with the body and none of the garment with itself", or "no triangles".
[[nodiscard]] std::string inWords(const dressing::Pairs& pairs);

/// How the garment was placed: "placed by neck, sleeves or waist".
[[nodiscard]] std::string inWords(dressing::PlacementRule rule);

/// What is wrong and what to do. Empty for Misfit::None.
/// @param garment, body their names  @param garmentSide, bodySide their largest extents [m]
[[nodiscard]] std::string inWords(dressing::Misfit misfit, const std::string& garment, const std::string& body,
                                  double garmentSide, double bodySide);

}  // namespace drape::app
