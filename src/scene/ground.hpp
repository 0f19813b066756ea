#pragma once

#include "scene/scene.hpp"

#include <span>

namespace drape::scene {

/// The height of the ground of a scene [m]. The scene's own value has priority. Otherwise the ground is at 0, or below
/// the cloth when the cloth starts at 0 or lower. "Below" leaves room for cloth that hangs from its pins.
/// @param start positions at the start [m], one per vertex  @param pins indices into it
[[nodiscard]] double groundHeightOf(const SceneDescription& description, std::span<const Vec3> start,
                                    std::span<const int> pins);

/// The lowest height that cloth at its pins can reach without stretching [m]. Without pins -infinity.
/// @param start positions at the start [m], one per vertex  @param pins indices into it
[[nodiscard]] double lowestHang(std::span<const Vec3> start, std::span<const int> pins);

}  // namespace drape::scene
