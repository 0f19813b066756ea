#pragma once

#include "sim/contact/broad_phase/cloth_clusters.hpp"
#include "sim/contact/closest_features/cloth_features.hpp"
#include "sim/model/cloth_model.hpp"

#include <cstdint>
#include <vector>

namespace drape::sim::contact {

/// The data of a cloth that body contact needs and that stay the same while the cloth moves.
struct PreparedCloth {
  PreparedCloth(const ClothModel& model, std::uint64_t identity);

  std::uint64_t number;  ///< identifies the cloth, so that cached data of another one are not used
  ClothClusters clusters;
  std::vector<OwnedFeatures> owned;  ///< one per triangle
  std::vector<int> pieces;           ///< one vertex of each connected piece
  std::vector<double> inverseMass;   ///< per vertex [1/kg]; 0 if it is pinned
};

}  // namespace drape::sim::contact
