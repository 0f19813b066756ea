#pragma once

#include "report/measurement.hpp"

#include <nlohmann/json.hpp>

namespace drape {

/// A measurement with everything in it; docs/guide/headless.md says what each entry means. What is not a number is
/// null.
[[nodiscard]] nlohmann::ordered_json measurementJson(const Measurement& measurement);

}  // namespace drape
