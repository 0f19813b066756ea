#pragma once

#include "scene/placements.hpp"

#include <optional>

namespace drape::scene {

/// The unit and the up axis with which the file of a cloth or a body is read, if the user can change them: those of the
/// only cloth of a scene, or of a body that was opened from a mesh file. Empty otherwise.
[[nodiscard]] std::optional<ReadingChoice> changeableReading(const Scene& scene, const Placeable& thing);

/// What a scene is built again with.
struct ReadingChange {
  settings::Settings settings;
  Placements placements;
};

/// Reads the file of a thing in another unit or with another up axis. The middle of the thing stays where it is.
/// @param thing with a changeableReading  @param to without "auto"
/// @param middle of the box around the thing without its placement, as it is read now [m]
/// @param present settings and placements
[[nodiscard]] ReadingChange withReading(const Scene& scene, const Placeable& thing, const ReadingChoice& to,
                                        const Vec3& middle, ReadingChange present);

}  // namespace drape::scene
