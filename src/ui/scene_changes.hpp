#pragma once

#include "session/user_state.hpp"

namespace drape::ui {

/// Whether quitting loses a change of the user: a setting outside the view, a pin, a placement, or a body's
/// position, surface or presence.
/// @param opened the scene as it was opened, with the settings of the command line
[[nodiscard]] bool hasChanges(const session::Snapshot& snapshot, const scene::Scene& opened);

/// The same between two states of the user.
[[nodiscard]] bool hasChanges(const session::UserState& now, const session::UserState& saved);

/// Whether "Reset all" would change a setting, a pin, a placement or a body.
[[nodiscard]] bool differsFromScene(const session::Snapshot& snapshot, const settings::Settings& inForce);

}  // namespace drape::ui
