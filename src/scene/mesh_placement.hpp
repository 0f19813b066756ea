#pragma once

#include "sim/contact/bodies/pose.hpp"
#include "sim/model/vector.hpp"

#include <string>

namespace drape::scene {

/// How the coordinates of a mesh file become those of the scene: the unit, then the up axis, then the placement of the
/// cloth. The default leaves them as they are, as for a grid.
struct MeshPlacement {
  double metresPerUnit = 1.0;
  std::string up = "y";     ///< the axis of the file that points up, as in the setting
  sim::contact::Pose pose;  ///< of the cloth in the scene
  double scale = 1.0;       ///< of the cloth in the scene [-]

  /// The point of the file at a point of the scene [m].
  [[nodiscard]] Vec3 toFile(const Vec3& inScene) const;
  /// The point of the scene [m] at a point of the file.
  [[nodiscard]] Vec3 toScene(const Vec3& inFile) const;
  /// The direction in the axes of the file.
  [[nodiscard]] Vec3 directionInFile(const Vec3& inScene) const;
};

/// Rotates a point so that the named axis becomes y.
[[nodiscard]] Vec3 turnedUpright(const Vec3& point, const std::string& up);

}  // namespace drape::scene
