#include "app/command_json.hpp"

#include "messages/error.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace drape {
namespace {

using Json = nlohmann::ordered_json;

// The name of each command and its fields: both directions use them.
constexpr std::string_view nameOf(const SetSettingCommand& /*command*/) {
  return "set";
}
constexpr std::string_view nameOf(const PauseCommand& /*command*/) {
  return "pause";
}
constexpr std::string_view nameOf(const SingleStepCommand& /*command*/) {
  return "single_step";
}
constexpr std::string_view nameOf(const ResetCommand& /*command*/) {
  return "reset";
}
constexpr std::string_view nameOf(const AttachCommand& /*command*/) {
  return "attach";
}
constexpr std::string_view nameOf(const MoveAttachmentCommand& /*command*/) {
  return "move_attachment";
}
constexpr std::string_view nameOf(const DetachCommand& /*command*/) {
  return "detach";
}
constexpr std::string_view nameOf(const TogglePinCommand& /*command*/) {
  return "toggle_pin";
}
constexpr std::string_view nameOf(const MovePinsCommand& /*command*/) {
  return "move_pins";
}
constexpr std::string_view nameOf(const SwitchBodyCommand& /*command*/) {
  return "switch_body";
}
constexpr std::string_view nameOf(const SetSurfaceCommand& /*command*/) {
  return "set_surface";
}
constexpr std::string_view nameOf(const MoveBodyCommand& /*command*/) {
  return "move_body";
}
constexpr std::string_view nameOf(const SetCostBudgetCommand& /*command*/) {
  return "set_cost_budget";
}
constexpr std::string_view nameOf(const LoadSceneCommand& /*command*/) {
  return "load_scene";
}

template <typename Command, typename Visitor>
void visitFields(Command& command, const Visitor& visit) {
  using Plain = std::remove_const_t<Command>;
  if constexpr (std::is_same_v<Plain, SetSettingCommand>) {
    visit("key", command.key);
    visit("value", command.value);
  } else if constexpr (std::is_same_v<Plain, PauseCommand>) {
    visit("paused", command.paused);
  } else if constexpr (std::is_same_v<Plain, AttachCommand>) {
    visit("triangle", command.triangle);
    visit("barycentric", command.barycentric);
    visit("target", command.target);
  } else if constexpr (std::is_same_v<Plain, MoveAttachmentCommand>) {
    visit("target", command.target);
  } else if constexpr (std::is_same_v<Plain, MovePinsCommand>) {
    visit("by", command.by);
  } else if constexpr (std::is_same_v<Plain, SwitchBodyCommand>) {
    visit("body", command.body);
    visit("on", command.on);
  } else if constexpr (std::is_same_v<Plain, SetSurfaceCommand>) {
    visit("body", command.body);
    visit("static_friction", command.surface.staticFriction);
    visit("kinetic_friction", command.surface.kineticFriction);
    visit("thickness", command.surface.thickness);
  } else if constexpr (std::is_same_v<Plain, MoveBodyCommand>) {
    visit("body", command.body);
    visit("shift", command.shift);
  } else if constexpr (std::is_same_v<Plain, SetCostBudgetCommand>) {
    visit("cost_budget", command.costBudget);
  }
}

void put(Json& json, const Vec3& value) {
  json = {value.x(), value.y(), value.z()};
}

void put(Json& json, const SettingValue& value) {
  std::visit([&](const auto& each) { json = each; }, value);
}

template <typename T>
void put(Json& json, const T& value) {
  json = value;
}

void take(const Json& json, Vec3& value) {
  for (int axis = 0; axis < 3; ++axis) {
    value[axis] = json.at(static_cast<std::size_t>(axis)).get<double>();
  }
}

void take(const Json& json, SettingValue& value) {
  if (json.is_boolean()) {
    value = json.get<bool>();
  } else if (json.is_number_integer()) {
    value = json.get<int>();
  } else if (json.is_number()) {
    value = json.get<double>();
  } else {
    value = json.get<std::string>();
  }
}

template <typename T>
void take(const Json& json, T& value) {
  value = json.get<T>();
}

/// A command of that name without its fields.
template <std::size_t Index = 0>
Command commandNamed(const std::string& name) {
  if constexpr (Index == std::variant_size_v<Command>) {
    throw InputError("there is no command '" + name + "'");
  } else {
    using Candidate = std::variant_alternative_t<Index, Command>;
    if (!std::is_same_v<Candidate, LoadSceneCommand> && name == nameOf(Candidate{})) {
      return Candidate{};
    }
    return commandNamed<Index + 1>(name);
  }
}

}  // namespace

Json toJson(const LoggedCommand& entry) {
  if (std::holds_alternative<LoadSceneCommand>(entry.command)) {
    throw InputError("a session log holds one scene; it cannot load another");
  }
  Json json;
  json["step"] = entry.step;
  std::visit(
      [&](const auto& command) {
        json["command"] = nameOf(command);
        visitFields(command, [&](const char* key, const auto& value) { put(json[key], value); });
      },
      entry.command);
  return json;
}

LoggedCommand commandFrom(const Json& json) {
  try {
    LoggedCommand entry{json.at("step").get<std::int64_t>(), commandNamed(json.at("command").get<std::string>())};
    std::visit(
        [&](auto& command) { visitFields(command, [&](const char* key, auto& value) { take(json.at(key), value); }); },
        entry.command);
    return entry;
  } catch (const Json::exception& error) {
    throw InputError("the entry " + json.dump() + " is not a command of a session log");
  }
}

}  // namespace drape
