#pragma once

#include "sim/contact/exact/edge_crossings.hpp"

#include <vector>

namespace drape::sim::testing {

/// The crossings of a cloth at its rest positions.
inline std::vector<contact::EdgeCrossing> crossingsAtRest(const ClothModel& model, const contact::FeatureMesh& mesh) {
  contact::MeshTree tree(model.restPositions, model.triangles, 8);
  contact::LeafBoxes boxes(mesh, tree);
  std::vector<contact::EdgeCrossing> found;
  findCrossings(mesh, tree, boxes, model.restPositions, found);
  return found;
}

}  // namespace drape::sim::testing
