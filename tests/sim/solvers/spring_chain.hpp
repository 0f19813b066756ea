#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/mesh_topology.hpp"

#include <cmath>
#include <memory>

namespace drape::sim::testing {

/// Masses that hang below each other at distances of `restLength`, each on a spring from the one above; the first is
/// pinned. Built without triangles: the smallest models whose motion is known in closed form.
inline std::shared_ptr<const ClothModel> hangingChain(int springs, double mass, double restLength) {
  auto model = std::make_shared<ClothModel>();
  const int count = springs + 1;
  for (int v = 0; v < count; ++v) {
    model->restPositions.emplace_back(0.0, -restLength * v, 0.0);
  }
  for (int v = 0; v < springs; ++v) {
    model->springs.push_back({v, v + 1, restLength});
  }
  const auto size = static_cast<std::size_t>(count);
  model->springEnds = springEndsOf(model->springs, size);
  model->vertexTriangles = trianglesOfVertices({}, size);
  model->vertexArea.assign(size, 0.0);
  model->vertexMass.assign(size, mass);
  model->pinned.assign(size, false);
  model->pinned[0] = true;
  const double neighbours = springs > 1 ? 2.0 : 1.0;
  model->unitFrequency = std::sqrt(2.0 * neighbours / mass);
  model->unitDampingRate = 2.0 * neighbours / mass;
  return model;
}

}  // namespace drape::sim::testing
