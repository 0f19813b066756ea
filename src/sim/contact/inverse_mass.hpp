#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::contact {

/// The inverse mass of each vertex [1/kg]; 0 if it is pinned.
[[nodiscard]] std::vector<double> inverseMassOf(const ClothModel& model);

}  // namespace drape::sim::contact
