#pragma once

#include "sim/model/vector.hpp"

#include <nlohmann/json.hpp>

namespace drape::app {

/// A vector as a list of three numbers.
[[nodiscard]] inline nlohmann::ordered_json vectorJson(const Vec3& vector) {
  return nlohmann::ordered_json::array({vector.x(), vector.y(), vector.z()});
}

/// The way back. Throws the exceptions of nlohmann::json.
[[nodiscard]] inline Vec3 vectorFrom(const nlohmann::ordered_json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace drape::app
