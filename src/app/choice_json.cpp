#include "app/choice_json.hpp"

#include "messages/step_choice_text.hpp"
#include "scene/cloth_material.hpp"

#include <string>

namespace drape::app {

nlohmann::ordered_json toJson(const std::optional<sim::adaptive::StepChoice>& choice,
                              std::span<const scene::ClothPart> cloths, const settings::Settings& settings) {
  if (!choice) {
    return nullptr;
  }
  const text::Sentence fabric = scene::materialInWords(cloths, settings, choice->softestMaterial);
  nlohmann::ordered_json json{{"words", messages::inWords(*choice, fabric).english()}};
  for (const auto& [name, value] : sim::adaptive::figuresOf(*choice)) {
    json[std::string(name)] = value;
  }
  return json;
}

}  // namespace drape::app
