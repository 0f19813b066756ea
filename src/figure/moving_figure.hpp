#pragma once

#include "figure/motions.hpp"
#include "figure/proportions.hpp"
#include "sim/contact/bodies/body.hpp"

#include <memory>
#include <vector>

namespace drape::figure {

/// How a figure moves, and its size.
struct FigureOptions {
  const Motion* motion = &motions().front();
  double speed = 1.0;  ///< of the motion [-]
  Proportions proportions;
};

/// The time in which a figure goes from the rest pose to its motion, and from the size as built to its own [s].
inline constexpr double blendTime = 1.0;

/// The figure as a body. At time 0 and before it stands in the rest pose, as it is built, with velocity 0.
/// @param positions, triangles of its mesh in the rest pose [m]
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> movingFigure(std::vector<Vec3> positions,
                                                                          std::vector<Triangle> triangles,
                                                                          const FigureOptions& options);

}  // namespace drape::figure
