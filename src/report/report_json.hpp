#pragma once

#include "report/measurement.hpp"

#include <nlohmann/json.hpp>

namespace drape::report {

/// A complete measurement; docs/guide/headless.md explains each entry. Values that are not finite are null.
[[nodiscard]] nlohmann::ordered_json measurementJson(const Measurement& measurement);

}  // namespace drape::report
