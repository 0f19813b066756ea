#include "sim/contact/exact/feature_tree.hpp"

#include <utility>

namespace drape::sim::contact {

FeatureTree featureTreeOf(const ClothModel& model) {
  constexpr int trianglesOfLeaf = 8;
  FeatureMesh mesh = featureMeshOf(model);
  MeshTree tree(model.restPositions, model.triangles, trianglesOfLeaf);
  LeafBoxes boxes(mesh, tree);
  return {std::move(mesh), std::move(tree), std::move(boxes)};
}

}  // namespace drape::sim::contact
