#pragma once

#include "sim/fabric/bending.hpp"
#include "sim/fabric/membrane.hpp"
#include "sim/model/cloth_model.hpp"

#include <span>

namespace drape::sim::fabric {

/// The square of the highest angular frequency of a free fabric at rest [1/s^2], by power iteration from below: on
/// garments the frequency is at most 3 % too low (tests/sim/fabric/frequency_test.cpp). The cost is that of
/// some dozens of force evaluations.
/// @param membrane the second derivative of each triangle's energy at rest [N/m]
/// @param bending without rows if the fabric does not resist bending [N/m]
[[nodiscard]] double highestFrequencySquared(const ClothModel& model, std::span<const Mat9> membrane,
                                             const VertexMatrix& bending);

}  // namespace drape::sim::fabric
