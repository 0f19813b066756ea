#include "app/choice_json.hpp"

#include "messages/step_choice_text.hpp"

#include <string>

namespace drape::app {

nlohmann::ordered_json toJson(const std::optional<sim::adaptive::StepChoice>& choice, const text::Sentence& fabric) {
  if (!choice) {
    return nullptr;
  }
  nlohmann::ordered_json json{{"words", messages::inWords(*choice, fabric).english()}};
  for (const auto& [name, value] : sim::adaptive::figuresOf(*choice)) {
    json[std::string(name)] = value;
  }
  return json;
}

}  // namespace drape::app
