#pragma once

#include "sim/model/cloth_model.hpp"

#include <vector>

namespace drape::sim::simd {

/// The order in which a step processes the vertices: order[k] is the vertex of the model with the permuted index k. It
/// is the order of the mesh if its bandwidth is small, as in a grid. Otherwise it is reverse Cuthill-McKee (1969), with
/// the vertices sorted within windows of 128 by their number of springs, and of neighbours by bending, so that the
/// lanes of a slice do equal work.
[[nodiscard]] std::vector<int> stepOrder(const ClothModel& model);

/// The largest difference between the permuted indices of a spring's ends in that order.
[[nodiscard]] int bandwidth(const ClothModel& model, const std::vector<int>& order);

}  // namespace drape::sim::simd
