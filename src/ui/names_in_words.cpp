#include "ui/names_in_words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace drape::ui {

using text::Sentence;

Sentence inWords(const scene::SceneDescription& description) {
  return description.title.empty() ? Sentence::verbatim(description.name) : Sentence(description.title);
}

Sentence inWords(const scene::SceneParts& parts) {
  if (!parts.cloth.empty()) {
    return Sentence::verbatim(parts.cloth);
  }
  const std::vector<scene::SceneInfo> builtIn = scene::sceneList();
  const auto found = std::ranges::find(builtIn, parts.scene, &scene::SceneInfo::name);
  return found == builtIn.end() ? Sentence::verbatim(parts.scene) : Sentence(found->title);
}

Sentence inWords(const scene::SceneDescription& description, const scene::Placeable& thing) {
  using Kind = scene::Placeable::Kind;
  if (thing.kind == Kind::Cloth && description.cloths.at(thing.index).name.empty()) {
    return Sentence("the cloth");
  }
  return Sentence::verbatim(scene::nameOf(description, thing));
}

}  // namespace drape::ui
