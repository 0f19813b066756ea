#include "report/number_text.hpp"

#include <cmath>
#include <limits>

namespace drape::report {

std::string figure(const nlohmann::ordered_json& row, const char* key, int digits) {
  return text::figure(numberIn(row, key), digits);
}

nlohmann::ordered_json finiteOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

double numberIn(const nlohmann::ordered_json& row, const char* key) {
  const auto found = row.find(key);
  return found != row.end() && found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string frameCost(const nlohmann::ordered_json& row) {
  return text::figure(msPerFrame(numberIn(row, "us_per_simulated_second")));
}

std::string gridText(int resolution) {
  return std::to_string(resolution) + "x" + std::to_string(resolution);
}

int resolutionIn(const nlohmann::ordered_json& row) {
  const auto found = row.find("resolution");
  return found != row.end() && found->is_number() ? found->get<int>() : 0;
}

nlohmann::ordered_json resolutionJson(int resolution) {
  return resolution == 0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(resolution);
}

std::string sizeText(int resolution) {
  return resolution == 0 ? "mesh" : gridText(resolution);
}

std::string stepText(double seconds) {
  return "1/" + text::figure(std::round(1.0 / seconds)) + " s";
}

}  // namespace drape::report
