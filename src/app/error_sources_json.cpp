#include "app/error_sources_json.hpp"

namespace drape::app {

nlohmann::ordered_json toJson(std::span<const sim::ErrorSources> sources) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const sim::ErrorSources& at : sources) {
    json.push_back(
        {{"time", at.time}, {"method", at.method}, {"mesh", at.mesh}, {"material", at.material}, {"start", at.start}});
  }
  return json;
}

}  // namespace drape::app
