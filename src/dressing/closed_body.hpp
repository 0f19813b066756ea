#pragma once

#include "sim/model/cloth_model.hpp"

namespace drape::dressing {

/// A mesh whose holes are filled.
struct ClosedBody {
  sim::ClothMesh mesh;  ///< every side of a triangle has one in the opposite direction; the given vertices come first
  int holes = 0;        ///< that were filled
  double addedArea = 0.0;  ///< of the filling over that of the given triangles [-]
};

/// Fills the holes of a mesh: each closed chain of sides without a partner becomes a fan of triangles around its mean.
/// Bodies of games need it: their eyes are missing, and hands, trousers and shoes are open where they meet.
/// @param body its triangles are counter-clockwise from outside [m]
[[nodiscard]] ClosedBody closedBody(sim::ClothMesh body);

}  // namespace drape::dressing
