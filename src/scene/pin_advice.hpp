#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <optional>

namespace drape {

/// What to tell a user whose pins hold all of the cloth, so that nothing moves, or none of it although something asks
/// for pins or the cloth is a mesh file that is opened by itself. Nothing to tell: no value.
[[nodiscard]] std::optional<Advice> adviceOnPins(const SceneDescription& description, const Settings& settings,
                                                 std::size_t pinned, std::size_t vertices);

}  // namespace drape
