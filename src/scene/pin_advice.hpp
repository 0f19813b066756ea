#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <optional>

namespace drape::scene {

/// Advice when the pins fix all vertices, or none although the scene defines pins or the cloth is a mesh file without a
/// scene. Empty otherwise.
[[nodiscard]] std::optional<Advice> adviceOnPins(const SceneDescription& description,
                                                 const settings::Settings& settings, std::size_t pinned,
                                                 std::size_t vertices);

}  // namespace drape::scene
