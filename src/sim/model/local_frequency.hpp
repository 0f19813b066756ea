#pragma once

#include "sim/model/cloth_model.hpp"

#include <cstddef>

namespace drape::sim {

/// omega_i^2 of one vertex in the rest shape, for springs of 1 N/m: 2 lambda_max(sum_j d d^T) / m_i [1/s^2]; with the
/// largest stiffness of the fabric there instead of lambda_max if the cloth has one. Pins are ignored.
///
/// The factor 2 makes it an estimate from above for springs. The stiffness of a fabric is scaled such that the largest
/// omega is 1.1 times the highest frequency at rest (tests/sim/fabric/frequency_test.cpp).
[[nodiscard]] double unitFrequencySquared(const ClothModel& model, std::size_t vertex);

}  // namespace drape::sim
