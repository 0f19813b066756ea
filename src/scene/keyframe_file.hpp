#pragma once

#include "scene/toml_reader.hpp"
#include "scene/toml_text.hpp"
#include "sim/contact/bodies/motion.hpp"

namespace drape::scene {

/// Reads `keyframes` and `loop` of a table, of a body or of pins (docs/guide/scenes.md). Throws InputError with file
/// and line.
/// @param start the values that the first keyframe does not give, and the only keyframe of a table without any
void readKeyframes(const TomlReader& table, const sim::contact::Keyframe& start, sim::contact::BodyMotion& motion);

/// Writes both.
void writeKeyframes(const sim::contact::BodyMotion& motion, TomlText& toml);

}  // namespace drape::scene
