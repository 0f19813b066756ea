#pragma once

#include "sim/contact/broad_phase/mesh_tree.hpp"
#include "sim/contact/exact/feature_boxes.hpp"

namespace drape::sim::contact {

/// The features of a cloth, and the bounding volumes for a search among them.
struct FeatureTree {
  FeatureMesh mesh;
  MeshTree tree;
  LeafBoxes boxes;
};

[[nodiscard]] FeatureTree featureTreeOf(const ClothModel& model);

}  // namespace drape::sim::contact
