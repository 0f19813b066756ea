#pragma once

#include "settings/own_fabrics.hpp"

#include <nlohmann/json.hpp>

namespace drape::app {

/// A fabric as JSON: name, based_on, source, and its values by the keys of their settings.
[[nodiscard]] nlohmann::ordered_json toJson(const settings::OwnFabric& fabric);
[[nodiscard]] nlohmann::ordered_json toJson(const settings::OwnFabrics& fabrics);

/// The way back. Throws InputError for a value out of its range, and the exceptions of nlohmann::json.
[[nodiscard]] settings::OwnFabric fabricFrom(const nlohmann::ordered_json& json);
[[nodiscard]] settings::OwnFabrics fabricsFrom(const nlohmann::ordered_json& json);

}  // namespace drape::app
