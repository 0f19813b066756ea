#pragma once

#include "sim/measures/error_sources.hpp"

#include <nlohmann/json.hpp>
#include <span>

namespace drape::app {

/// The sources of error at each time, as an array of objects with all members by name.
[[nodiscard]] nlohmann::ordered_json toJson(std::span<const sim::ErrorSources> sources);

}  // namespace drape::app
