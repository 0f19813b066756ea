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

/// The length of a frame of the screen [s]. The pages show costs as milliseconds per frame.
inline constexpr double frameSeconds = 1.0 / 60.0;

/// Converts a cost in us per simulated second to ms per frame.
[[nodiscard]] inline double msPerFrame(double usPerSimulatedSecond) {
  constexpr double milliseconds = 1e-3;
  return milliseconds * frameSeconds * usPerSimulatedSecond;
}

/// The `us_per_simulated_second` of a row in ms per frame; "-" when it is missing.
[[nodiscard]] std::string frameCost(const nlohmann::ordered_json& row);

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
