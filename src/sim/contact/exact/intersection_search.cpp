#include "sim/contact/exact/intersection_search.hpp"

namespace drape::sim::contact {

void IntersectionSearch::find(const ClothModel& model, std::span<const Vec3> positions,
                              std::vector<IntersectionSegment>& segments) {
  FeatureTree& tree = trees_.get(model, featureTreeOf);
  findCrossings(tree.mesh, tree.tree, tree.boxes, positions, crossings_);
  segments = segmentsOf(tree.mesh, crossings_, positions);
}

}  // namespace drape::sim::contact
