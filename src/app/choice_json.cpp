#include "app/choice_json.hpp"

#include "messages/step_choice_text.hpp"

#include <string>

namespace drape {

nlohmann::ordered_json toJson(const std::optional<StepChoice>& choice) {
  if (!choice) {
    return nullptr;
  }
  nlohmann::ordered_json json{{"words", inWords(*choice)}};
  for (const auto& [name, value] : figuresOf(*choice)) {
    json[std::string(name)] = value;
  }
  return json;
}

}  // namespace drape
