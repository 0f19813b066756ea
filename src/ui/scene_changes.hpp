#pragma once

#include "session/snapshot.hpp"

#include <memory>

namespace drape {

/// True when the user changed something that is lost with the program: a setting of anything but the view, a pin, or a
/// body's place, surface or presence.
/// @param opened the scene as it was opened, with the settings of the command line
[[nodiscard]] bool hasChanges(const Snapshot& snapshot, const Scene& opened);

/// True when "Reset all" would change a setting, a pin or a body.
[[nodiscard]] bool differsFromScene(const Snapshot& snapshot, const Settings& inForce);

}  // namespace drape
