#pragma once

#include "scene/placements.hpp"
#include "scene/scene.hpp"
#include "text/sentence.hpp"

namespace drape::ui {

/// A scene in a sentence: its title, or its name if it has none.
[[nodiscard]] text::Sentence inWords(const scene::SceneDescription& description);

/// What is opened, in a sentence: the title of a built-in scene, or the name of the file.
[[nodiscard]] text::Sentence inWords(const scene::SceneParts& parts);

/// A cloth or a body in a sentence: its name, or "the cloth" for one without a name.
[[nodiscard]] text::Sentence inWords(const scene::SceneDescription& description, const scene::Placeable& thing);

}  // namespace drape::ui
