#pragma once

#include "sim/contact/self/float_lanes.hpp"
#include "sim/contact/self/patch_updater.hpp"
#include "sim/contact/self/response.hpp"

namespace drape::sim::contact {

/// Data that self-collision keeps between steps. Later results depend on it, so it is part of the state of a cloth, and
/// a copied state continues with the same bits. It does not change once it belongs to a state. Exact self-collision
/// uses only the patches and the sizes of the mesh.
struct SelfContactMemory {
  PatchHistory patches;
  PositionLanes positions;  ///< positions at the last search for pairs [m]
  ColouredPairs pairs;      ///< pairs within `reach` that this search found
  double thickness = 0.0;   ///< [m]
  double reach = 0.0;       ///< thickness plus the relative displacement that requires the next search [m]
  int vertices = 0;         ///< number of vertices of the mesh
  int triangles = 0;        ///< number of triangles of the mesh
  int searches = 0;         ///< number of searches so far
};

}  // namespace drape::sim::contact
