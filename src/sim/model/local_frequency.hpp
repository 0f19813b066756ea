#pragma once

#include "sim/model/cloth_model.hpp"

#include <cstddef>

namespace drape::sim {

/// omega_i^2 / k of one vertex in the rest shape: 2 lambda_max(sum_j d d^T) / m_i [1/kg]; pins are ignored.
[[nodiscard]] double unitFrequencySquared(const ClothModel& model, std::size_t vertex);

}  // namespace drape::sim
