#pragma once

#include "sim/cloth_model.hpp"

#include <vector>

namespace drape {

/// The order in which a step goes through the vertices: order[k] is the vertex of the model that comes k-th. The mesh's
/// own order where neighbours are near each other in it already, as in a grid; else reverse Cuthill-McKee (1969), with
/// vertices of equal numbers of springs put together in windows of 128, so that lanes do the same work.
[[nodiscard]] std::vector<int> stepOrder(const ClothModel& model);

/// How far apart the ends of a spring are at most when the vertices stand in that order.
[[nodiscard]] int bandwidth(const ClothModel& model, const std::vector<int>& order);

}  // namespace drape
