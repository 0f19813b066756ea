#pragma once

#include "scene/pin_path.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::session {

/// Pins, and the place of each [m].
struct PinMoves {
  std::vector<int> vertices;
  std::vector<Vec3> places;
};

/// Where pins go when other keyframes replace theirs at the time of the state: from where the earlier path has them now
/// to where the later one has them. A pin without a path is at its start.
[[nodiscard]] PinMoves movesBetween(const std::vector<scene::PinPath>& earlier,
                                    const std::vector<scene::PinPath>& later, const sim::ClothModel& model,
                                    const sim::ClothState& state);

/// Moves vertices to places [m], one each, and stops them.
void placeVertices(const std::vector<int>& vertices, const std::vector<Vec3>& places, sim::ClothState& state);

}  // namespace drape::session
