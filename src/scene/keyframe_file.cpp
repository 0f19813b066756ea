#include "scene/keyframe_file.hpp"

#include "text/number_text.hpp"

#include <fmt/core.h>
#include <optional>
#include <string>

namespace drape::scene {
namespace {

constexpr double maxTime = 1e6;    // [s]
constexpr double manyTurns = 1e6;  // [degrees]

sim::contact::Keyframe readKeyframe(const TomlReader& table, const sim::contact::Keyframe& usual) {
  table.allowOnly({"time", "position", "rotation"});
  sim::contact::Keyframe key = usual;
  const auto time = table.number("time", -maxTime, maxTime);
  if (!time) {
    table.fail("a keyframe needs a time");
  }
  key.time = *time;
  key.position = table.vector("position").value_or(usual.position);
  if (const auto rotation = table.vector("rotation", manyTurns)) {
    key.rotation = degree * *rotation;
  }
  return key;
}

}  // namespace

void readKeyframes(const TomlReader& table, const sim::contact::Keyframe& start, sim::contact::BodyMotion& motion) {
  for (const TomlReader& key : table.tables("keyframes")) {
    const sim::contact::Keyframe next = readKeyframe(key, motion.keyframes.empty() ? start : motion.keyframes.back());
    if (!motion.keyframes.empty() && !(next.time > motion.keyframes.back().time)) {
      key.fail("the times of the keyframes must ascend");
    }
    motion.keyframes.push_back(next);
  }
  if (motion.keyframes.empty()) {
    motion.keyframes.push_back(start);
  }
  motion.loop = table.flag("loop").value_or(false);
  if (motion.loop && motion.keyframes.size() < 2) {
    table.fail("loop needs at least two keyframes");
  }
}

void writeKeyframes(const sim::contact::BodyMotion& motion, TomlText& toml) {
  std::string keys;
  for (const sim::contact::Keyframe& key : motion.keyframes) {
    keys += fmt::format("  {{ time = {}, position = {}, rotation = {} }},\n", text::exactNumber(key.time),
                        vectorText(key.position), degreesText(key.rotation));
  }
  toml.value("keyframes", "[\n" + keys + "]");
  toml.flag("loop", motion.loop);
}

}  // namespace drape::scene
