#pragma once

#include "session/command.hpp"
#include "session/snapshot.hpp"

#include <optional>
#include <span>
#include <vector>

namespace drape::ui {

/// The pinned ones of some vertices.
[[nodiscard]] std::vector<int> pinnedOf(const session::Snapshot& snapshot, std::span<const int> vertices);

/// The motion that all these pins follow by keyframes; null: they are not on one path.
[[nodiscard]] const sim::contact::BodyMotion* commonMotion(const session::Snapshot& snapshot,
                                                           std::span<const int> pins);

/// Gives these pins a motion of their own, which takes them to where it has them now.
/// @param motion without keyframes: the pins have none from now on, and return to their start
[[nodiscard]] session::SetPinPathsCommand withMotion(const session::Snapshot& snapshot, std::span<const int> pins,
                                                     sim::contact::BodyMotion motion);

/// Adds a keyframe at the present time, or replaces the one at that time, so that the pins are then where they are now.
/// The first keyframe of pins also makes one at the start of the scene.
[[nodiscard]] session::SetPinPathsCommand withKeyframeHere(const session::Snapshot& snapshot,
                                                           std::span<const int> pins);

}  // namespace drape::ui
