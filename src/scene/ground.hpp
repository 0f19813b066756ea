#pragma once

#include "scene/scene.hpp"

#include <span>

namespace drape {

/// The height of the ground of a scene [m]. What the scene says counts. A scene that says nothing has its ground at 0,
/// or below the cloth where the cloth starts at 0 or lower. "Below" is low enough for cloth that hangs from its pins.
/// @param start where the cloth starts [m], one place a vertex  @param pins indices into it
[[nodiscard]] double groundHeightOf(const SceneDescription& description, std::span<const Vec3> start,
                                    std::span<const int> pins);

}  // namespace drape
