#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::sim {

/// The largest strain of the springs under the cloth's weight at rest [-], an estimate. The springs that cross a given
/// distance from the pins, measured along the springs, carry the weight of everything beyond it. The largest strain
/// over all distances counts. Springs are assumed to pull along their rest direction. 0 for cloth without pins,
/// infinite for cloth without stiffness. A fabric counts as springs of about its stretch modulus (stretchStiffness),
/// which gives the order of its strain.
[[nodiscard]] double strainByWeight(const ClothModel& model, const CommonParameters& parameters);

}  // namespace drape::sim
