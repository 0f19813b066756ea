#include "scene/pin_advice.hpp"

#include <algorithm>

namespace drape::scene {
namespace {

/// Whether a scene defines pins. A table in its file does, even if it selects nothing.
bool namesPins(const PinSelection& pins) {
  return !pins.where.empty() || !pins.vertices.empty() || !pins.nearest.empty() || !pins.boxes.empty() || pins.top ||
         !pins.corners.empty() || !pins.edges.empty();
}

/// The first table that defines pins; nullptr if there is none.
const PinSelection* firstNamed(const SceneDescription& description) {
  for (const ClothDescription& cloth : description.cloths) {
    const auto found = std::find_if(cloth.pins.begin(), cloth.pins.end(), namesPins);
    if (found != cloth.pins.end()) {
      return &*found;
    }
  }
  return nullptr;
}

}  // namespace

std::optional<Advice> adviceOnPins(const SceneDescription& description, const settings::Settings& settings,
                                   std::size_t pinned, std::size_t vertices) {
  const bool byShape = settings.mesh.pins == "shape";
  const std::string cure = byShape ? "none" : "shape";
  const text::Sentence byShapeButton("Pin by shape");
  const text::Sentence button = byShape ? text::Sentence("Pin nothing") : byShapeButton;
  const auto isFrozen = [](const ClothDescription& cloth) { return cloth.frozen; };
  if (pinned > 0 && pinned == vertices && std::ranges::all_of(description.cloths, isFrozen)) {
    return Advice{
        text::Sentence("Every cloth is frozen, so nothing can move. Remove frozen = true from the scene file."),
        {},
        {},
        {}};
  }
  if (pinned > 0 && pinned == vertices) {
    return Advice{text::Sentence("All {} vertices are pinned, so nothing can move.", vertices), "pins", cure, button};
  }
  if (pinned > 0) {
    return std::nullopt;
  }
  const PinSelection* naming = firstNamed(description);
  if (settings.mesh.pins == "scene" && naming != nullptr) {
    text::Sentence words = text::Sentence::verbatim(naming->where);
    words.append(": ", text::Sentence("[pins] contains no vertex of this cloth, so it falls."));
    return Advice{words, "pins", "shape", byShapeButton};
  }
  if (description.opened && description.bodies.empty()) {
    return Advice{text::Sentence("Nothing is pinned, so the cloth falls."), "pins", "shape", byShapeButton};
  }
  return std::nullopt;
}

}  // namespace drape::scene
