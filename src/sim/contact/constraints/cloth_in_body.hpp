#pragma once

#include "sim/contact/closest_features/cloth_features.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim::contact {

class Overlap;

/// The cloth in the frame of a body. In this frame a rigid body stands still.
struct ClothInBody {
  /// Positions at the beginning of a pass [m]: those at the start of the step, or the result of the pass before. In
  /// this frame the start of the step has moved along with the body.
  std::span<const Vec3> start;
  std::span<const Vec3> predicted;             ///< positions at the end of the step, predicted or solved so far [m]
  std::span<const double> displacementBounds;  ///< maximum distance of each vertex from `start` [m]
  std::span<const Triangle> triangles;
  std::span<const OwnedFeatures> owned;
  std::span<const double> inverseMass;  ///< per vertex [1/kg]; 0: the vertex does not move
  const Overlap* overlap = nullptr;     ///< the part of the cloth inside the body; null if there is none
};

}  // namespace drape::sim::contact
