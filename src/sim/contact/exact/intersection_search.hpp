#pragma once

#include "sim/contact/exact/feature_tree.hpp"
#include "sim/contact/exact/intersection_contours.hpp"
#include "sim/model/model_cache.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// Finds where a cloth intersects itself, for drawing.
class IntersectionSearch {
 public:
  /// @param positions of the vertices [m]  @param segments replaced, see segmentsOf
  void find(const ClothModel& model, std::span<const Vec3> positions, std::vector<IntersectionSegment>& segments);

 private:
  ModelCache<FeatureTree> trees_;
  std::vector<EdgeCrossing> crossings_;
};

}  // namespace drape::sim::contact
