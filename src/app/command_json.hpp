#pragma once

#include "session/command.hpp"

#include <nlohmann/json.hpp>

namespace drape::app {

/// A command as JSON: {"step": 12, "command": "attach", "triangle": 3, ...}. Numbers keep all bits.
/// Throws InputError for a command that loads a scene: a log belongs to one scene.
[[nodiscard]] nlohmann::ordered_json toJson(const session::LoggedCommand& entry);

/// The command that `toJson` wrote. Throws InputError that names the wrong entry.
[[nodiscard]] session::LoggedCommand commandFrom(const nlohmann::ordered_json& json);

}  // namespace drape::app
