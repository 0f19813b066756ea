#pragma once

#include "render/camera.hpp"
#include "scene/placements.hpp"
#include "session/snapshot.hpp"
#include "sim/model/vector.hpp"

#include <optional>
#include <string>
#include <vector>

namespace drape::ui {

/// A cloth or a body at the start of a scene, without its placement.
struct PlacedShape {
  std::vector<Vec3> points;  ///< [m]
  double radius = 0.0;       ///< of a ball around each point, as of a sphere or a capsule [m]

  /// The box around it.
  [[nodiscard]] Eigen::AlignedBox3d box() const;
  /// The height of its lowest point with this placement [m].
  [[nodiscard]] double lowest(const scene::Placement& placement) const;
};

[[nodiscard]] PlacedShape placedShapeOf(const scene::Scene& scene, const scene::Placeable& thing);

/// Shows the start of a scene with other placements in a snapshot: positions of the cloth, and poses and vertices of
/// the bodies. A preview, the same up to rounding as the scene that is built with them.
void showPlaced(const scene::Placements& placements, session::Snapshot& snapshot);

/// The distance from the ground to a thing that lies on it [m]: cloth keeps its contact offset.
[[nodiscard]] double gapToGround(const session::Snapshot& snapshot, const scene::Placeable& thing);

/// What is under the mouse at the start of a scene: a thing that can be placed, or a sentence about something else.
struct PlacedHit {
  std::optional<scene::Placeable> thing;
  std::string refusal;  ///< why it cannot be placed; empty if it can, or if nothing is there
};

/// @param snapshot of showPlaced
[[nodiscard]] PlacedHit placedHitBy(const render::Ray& ray, const session::Snapshot& snapshot);

}  // namespace drape::ui
