#pragma once

#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace drape::scene {

/// What the view of a scene without a camera shows.
struct ViewedThings {
  const SceneDescription& description;
  std::span<const Vec3> start;                    ///< of the cloth [m]
  std::span<const int> pins;                      ///< indices into it
  const std::vector<sim::contact::Body>& bodies;  ///< at their start
  double groundHeight = 0.0;                      ///< [m]
};

/// The camera of the description, or one that shows the cloth at its start, the space into which it falls or sags, and
/// bodies that are not much larger than the cloth.
[[nodiscard]] CameraPose usualView(const ViewedThings& things);

}  // namespace drape::scene
