#pragma once

#include "text/number_text.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace drape::report {

/// A number in JSON with this number of significant digits; "-" when it is missing.
[[nodiscard]] std::string figure(const nlohmann::ordered_json& row, const char* key, int digits = 3);

/// A number for JSON: null when it is not finite.
[[nodiscard]] nlohmann::ordered_json finiteOrNull(double value);

/// The number of that name in a row; not a number when it is missing.
[[nodiscard]] double numberIn(const nlohmann::ordered_json& row, const char* key);

/// "17x17".
[[nodiscard]] std::string gridText(int resolution);

/// The resolution of the cloth of a row; 0 for a mesh, whose entry is null.
[[nodiscard]] int resolutionIn(const nlohmann::ordered_json& row);
/// The entry for a resolution; null for 0, a mesh.
[[nodiscard]] nlohmann::ordered_json resolutionJson(int resolution);
/// "17x17", or "mesh" for 0.
[[nodiscard]] std::string sizeText(int resolution);

/// A step in words: "1/150 s".
[[nodiscard]] std::string stepText(double seconds);

}  // namespace drape::report
