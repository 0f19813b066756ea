#include "app/command_json.hpp"

#include "app/fabric_json.hpp"
#include "messages/error.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

// The name of each command and its fields: both directions use them.
constexpr std::string_view nameOf(const session::SetSettingCommand& /*command*/) {
  return "set";
}
constexpr std::string_view nameOf(const session::UseFabricCommand& /*command*/) {
  return "use_fabric";
}
constexpr std::string_view nameOf(const session::SetOwnFabricsCommand& /*command*/) {
  return "set_own_fabrics";
}
constexpr std::string_view nameOf(const session::PauseCommand& /*command*/) {
  return "pause";
}
constexpr std::string_view nameOf(const session::SingleStepCommand& /*command*/) {
  return "single_step";
}
constexpr std::string_view nameOf(const session::ResetCommand& /*command*/) {
  return "reset";
}
constexpr std::string_view nameOf(const session::AttachCommand& /*command*/) {
  return "attach";
}
constexpr std::string_view nameOf(const session::MoveAttachmentCommand& /*command*/) {
  return "move_attachment";
}
constexpr std::string_view nameOf(const session::DetachCommand& /*command*/) {
  return "detach";
}
constexpr std::string_view nameOf(const session::TogglePinCommand& /*command*/) {
  return "toggle_pin";
}
constexpr std::string_view nameOf(const session::MovePinsCommand& /*command*/) {
  return "move_pins";
}
constexpr std::string_view nameOf(const session::UntangleCommand& /*command*/) {
  return "untangle";
}
constexpr std::string_view nameOf(const session::SwitchBodyCommand& /*command*/) {
  return "switch_body";
}
constexpr std::string_view nameOf(const session::SetSurfaceCommand& /*command*/) {
  return "set_surface";
}
constexpr std::string_view nameOf(const session::MoveBodyCommand& /*command*/) {
  return "move_body";
}
constexpr std::string_view nameOf(const session::SetCostBudgetCommand& /*command*/) {
  return "set_cost_budget";
}
constexpr std::string_view nameOf(const session::LoadSceneCommand& /*command*/) {
  return "load_scene";
}

template <typename Command, typename Visitor>
void visitFields(Command& command, const Visitor& visit) {
  using Plain = std::remove_const_t<Command>;
  if constexpr (std::is_same_v<Plain, session::SetSettingCommand>) {
    visit("key", command.key);
    visit("value", command.value);
  } else if constexpr (std::is_same_v<Plain, session::UseFabricCommand>) {
    visit("fabric", command.fabric);
  } else if constexpr (std::is_same_v<Plain, session::SetOwnFabricsCommand>) {
    visit("fabrics", command.fabrics);
  } else if constexpr (std::is_same_v<Plain, session::PauseCommand>) {
    visit("paused", command.paused);
  } else if constexpr (std::is_same_v<Plain, session::AttachCommand>) {
    visit("triangle", command.triangle);
    visit("barycentric", command.barycentric);
    visit("target", command.target);
  } else if constexpr (std::is_same_v<Plain, session::MoveAttachmentCommand>) {
    visit("target", command.target);
  } else if constexpr (std::is_same_v<Plain, session::MovePinsCommand>) {
    visit("by", command.by);
  } else if constexpr (std::is_same_v<Plain, session::SwitchBodyCommand>) {
    visit("body", command.body);
    visit("on", command.on);
  } else if constexpr (std::is_same_v<Plain, session::SetSurfaceCommand>) {
    visit("body", command.body);
    visit("static_friction", command.surface.staticFriction);
    visit("kinetic_friction", command.surface.kineticFriction);
    visit("thickness", command.surface.thickness);
  } else if constexpr (std::is_same_v<Plain, session::MoveBodyCommand>) {
    visit("body", command.body);
    visit("shift", command.shift);
  } else if constexpr (std::is_same_v<Plain, session::SetCostBudgetCommand>) {
    visit("cost_budget", command.costBudget);
  }
}

void put(Json& json, const Vec3& value) {
  json = {value.x(), value.y(), value.z()};
}

void put(Json& json, const settings::SettingValue& value) {
  std::visit([&](const auto& each) { json = each; }, value);
}

void put(Json& json, const settings::OwnFabric& fabric) {
  json = toJson(fabric);
}

void put(Json& json, const settings::OwnFabrics& fabrics) {
  json = toJson(fabrics);
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

void take(const Json& json, settings::SettingValue& value) {
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

void take(const Json& json, settings::OwnFabric& fabric) {
  fabric = fabricFrom(json);
}

void take(const Json& json, settings::OwnFabrics& fabrics) {
  fabrics = fabricsFrom(json);
}

template <typename T>
void take(const Json& json, T& value) {
  value = json.get<T>();
}

/// A command of that name without its fields.
template <std::size_t Index = 0>
session::Command commandNamed(const std::string& name) {
  if constexpr (Index == std::variant_size_v<session::Command>) {
    throw messages::InputError("there is no command '" + name + "'");
  } else {
    using Candidate = std::variant_alternative_t<Index, session::Command>;
    if (!std::is_same_v<Candidate, session::LoadSceneCommand> && name == nameOf(Candidate{})) {
      return Candidate{};
    }
    return commandNamed<Index + 1>(name);
  }
}

}  // namespace

Json toJson(const session::LoggedCommand& entry) {
  if (std::holds_alternative<session::LoadSceneCommand>(entry.command)) {
    throw messages::InputError("a session log holds one scene; it cannot load another");
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

session::LoggedCommand commandFrom(const Json& json) {
  try {
    session::LoggedCommand entry{json.at("step").get<std::int64_t>(),
                                 commandNamed(json.at("command").get<std::string>())};
    std::visit(
        [&](auto& command) { visitFields(command, [&](const char* key, auto& value) { take(json.at(key), value); }); },
        entry.command);
    return entry;
  } catch (const Json::exception& error) {
    throw messages::InputError("the entry " + json.dump() + " is not a command of a session log");
  }
}

}  // namespace drape::app
