#include "app/command_json.hpp"

#include "app/fabric_json.hpp"
#include "app/vector_json.hpp"
#include "messages/error.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

/// A field of a command: its key, and a pointer to the member or a function that returns it.
template <typename Member>
struct Field {
  const char* key;
  Member member;
};
template <typename Member>
Field(const char*, Member) -> Field<Member>;

/// The name and the fields of a command.
template <typename Command, typename... Fields>
struct CommandRow {
  using Type = Command;
  std::string_view name;
  std::tuple<Fields...> fields;
};

template <typename Command, typename... Fields>
constexpr CommandRow<Command, Fields...> row(std::string_view name, Fields... fields) {
  return {name, {fields...}};
}

/// A number of the surface that a command gives a body.
struct SurfaceField {
  double sim::contact::SurfaceProperties::*value;

  template <typename Command>
  constexpr auto& operator()(Command& command) const {
    return command.surface.*value;
  }
};

// Both directions use this table. A command without a row does not compile.
constexpr std::tuple table{
    row<session::SetSettingCommand>("set", Field{"key", &session::SetSettingCommand::key},
                                    Field{"value", &session::SetSettingCommand::value}),
    row<session::UseFabricCommand>("use_fabric", Field{"fabric", &session::UseFabricCommand::fabric}),
    row<session::SetOwnFabricsCommand>("set_own_fabrics", Field{"fabrics", &session::SetOwnFabricsCommand::fabrics}),
    row<session::PauseCommand>("pause", Field{"paused", &session::PauseCommand::paused}),
    row<session::SingleStepCommand>("single_step"),
    row<session::ResetCommand>("reset"),
    row<session::AttachCommand>("attach", Field{"triangle", &session::AttachCommand::triangle},
                                Field{"barycentric", &session::AttachCommand::barycentric},
                                Field{"target", &session::AttachCommand::target}),
    row<session::MoveAttachmentCommand>("move_attachment", Field{"target", &session::MoveAttachmentCommand::target}),
    row<session::DetachCommand>("detach"),
    row<session::TogglePinCommand>("toggle_pin"),
    row<session::SetPinsCommand>("set_pins", Field{"vertices", &session::SetPinsCommand::vertices}),
    row<session::PlacePinsCommand>("place_pins", Field{"vertices", &session::PlacePinsCommand::vertices},
                                   Field{"places", &session::PlacePinsCommand::places}),
    row<session::MovePinsCommand>("move_pins", Field{"by", &session::MovePinsCommand::by}),
    row<session::SetPinPathsCommand>("set_pin_paths", Field{"paths", &session::SetPinPathsCommand::paths},
                                     Field{"moves", &session::SetPinPathsCommand::moves}),
    row<session::SetSewingCommand>("set_sewing", Field{"sewing", &session::SetSewingCommand::sewing}),
    row<session::UntangleCommand>("untangle"),
    row<session::PlaceClothCommand>("place_cloth", Field{"positions", &session::PlaceClothCommand::positions},
                                    Field{"is_start", &session::PlaceClothCommand::isStart}),
    row<session::SwitchBodyCommand>("switch_body", Field{"body", &session::SwitchBodyCommand::body},
                                    Field{"on", &session::SwitchBodyCommand::on}),
    row<session::SetSurfaceCommand>(
        "set_surface", Field{"body", &session::SetSurfaceCommand::body},
        Field{"static_friction", SurfaceField{&sim::contact::SurfaceProperties::staticFriction}},
        Field{"kinetic_friction", SurfaceField{&sim::contact::SurfaceProperties::kineticFriction}},
        Field{"thickness", SurfaceField{&sim::contact::SurfaceProperties::thickness}}),
    row<session::MoveBodyCommand>("move_body", Field{"body", &session::MoveBodyCommand::body},
                                  Field{"shift", &session::MoveBodyCommand::shift}),
    row<session::SetFigureCommand>("set_figure", Field{"body", &session::SetFigureCommand::body},
                                   Field{"figure", &session::SetFigureCommand::figure}),
    row<session::GoToCommand>("go_to", Field{"time", &session::GoToCommand::time}),
    row<session::StepBackCommand>("step_back"),
    row<session::ObserveCommand>("observe", Field{"on", &session::ObserveCommand::on}),
    row<session::SetCostBudgetCommand>("set_cost_budget",
                                       Field{"cost_budget", &session::SetCostBudgetCommand::costBudget}),
};

/// The row of a type of command.
template <typename Command, std::size_t Index = 0>
constexpr const auto& rowOf() {
  if constexpr (std::is_same_v<typename std::tuple_element_t<Index, decltype(table)>::Type, Command>) {
    return std::get<Index>(table);
  } else {
    return rowOf<Command, Index + 1>();
  }
}

/// Calls visit(key, value) for each field of a command.
template <typename Command, typename Visitor>
void visitFields(Command& command, const Visitor& visit) {
  std::apply([&](const auto&... fields) { (visit(fields.key, std::invoke(fields.member, command)), ...); },
             rowOf<std::remove_const_t<Command>>().fields);
}

void put(Json& json, const Vec3& value) {
  json = vectorJson(value);
}

void put(Json& json, const std::vector<Vec3>& values) {
  json = Json::array();
  for (const Vec3& value : values) {
    put(json.emplace_back(), value);
  }
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

void put(Json& json, const figure::FigureOptions& figure) {
  json["motion"] = std::string(figure.motion->name);
  json["speed"] = figure.speed;
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (const std::optional<double>& size = figure.proportions.*each.value) {
      json[std::string(each.key)] = *size;
    }
  }
}

void put(Json& json, const std::vector<scene::PinPath>& paths) {
  json = Json::array();
  for (const scene::PinPath& path : paths) {
    Json& entry = json.emplace_back();
    entry["vertices"] = path.vertices;
    put(entry["centre"], path.centre);
    for (const sim::contact::Keyframe& key : path.motion.keyframes) {
      Json& frame = entry["keyframes"].emplace_back();
      frame["time"] = key.time;
      put(frame["position"], key.position);
      put(frame["rotation"], key.rotation);
    }
    entry["loop"] = path.motion.loop;
  }
}

void put(Json& json, const scene::SeamDescription& seam) {
  for (const scene::BorderDescription& side : seam.sides) {
    Json& entry = json["sides"].emplace_back();
    entry["cloth"] = side.cloth;
    entry["vertices"] = side.vertices;
    put(entry["nearest"], side.nearest);
  }
  json["pairs"] = seam.pairs;
  json["duration"] = seam.duration;
  json["reversed"] = seam.isReversed;
}

void put(Json& json, const scene::BandDescription& band) {
  put(json["nearest"], band.nearest);
  json["vertices"] = band.vertices;
  json["length"] = band.length;
}

void put(Json& json, const scene::Sewing& sewing) {
  json["seams"] = Json::array();
  for (const scene::SeamDescription& seam : sewing.seams) {
    put(json["seams"].emplace_back(), seam);
  }
  json["bands"] = Json::array();
  for (const std::vector<scene::BandDescription>& ofCloth : sewing.bands) {
    Json& list = json["bands"].emplace_back(Json::array());
    for (const scene::BandDescription& band : ofCloth) {
      put(list.emplace_back(), band);
    }
  }
}

template <typename T>
void put(Json& json, const T& value) {
  json = value;
}

void take(const Json& json, Vec3& value) {
  value = vectorFrom(json);
}

void take(const Json& json, std::vector<Vec3>& values) {
  for (const Json& each : json) {
    take(each, values.emplace_back());
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

void take(const Json& json, figure::FigureOptions& figure) {
  const auto name = json.at("motion").get<std::string>();
  figure.motion = figure::findMotion(name);
  if (figure.motion == nullptr) {
    throw messages::InputError("there is no motion '" + name + "'");
  }
  figure.speed = json.at("speed").get<double>();
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (const auto found = json.find(std::string(each.key)); found != json.end()) {
      figure.proportions.*each.value = found->get<double>();
    }
  }
}

void take(const Json& json, std::vector<scene::PinPath>& paths) {
  for (const Json& entry : json) {
    scene::PinPath& path = paths.emplace_back();
    path.vertices = entry.at("vertices").get<std::vector<int>>();
    take(entry.at("centre"), path.centre);
    for (const Json& frame : entry.at("keyframes")) {
      sim::contact::Keyframe& key = path.motion.keyframes.emplace_back();
      key.time = frame.at("time").get<double>();
      take(frame.at("position"), key.position);
      take(frame.at("rotation"), key.rotation);
    }
    path.motion.loop = entry.at("loop").get<bool>();
  }
}

void take(const Json& json, scene::SeamDescription& seam) {
  for (std::size_t i = 0; i < seam.sides.size(); ++i) {
    const Json& entry = json.at("sides").at(i);
    seam.sides[i].cloth = entry.at("cloth").get<std::string>();
    seam.sides[i].vertices = entry.at("vertices").get<std::vector<int>>();
    take(entry.at("nearest"), seam.sides[i].nearest);
  }
  seam.pairs = json.at("pairs").get<std::vector<std::array<int, 2>>>();
  seam.duration = json.at("duration").get<double>();
  seam.isReversed = json.at("reversed").get<bool>();
}

void take(const Json& json, scene::BandDescription& band) {
  take(json.at("nearest"), band.nearest);
  band.vertices = json.at("vertices").get<std::vector<int>>();
  band.length = json.at("length").get<double>();
}

void take(const Json& json, scene::Sewing& sewing) {
  for (const Json& entry : json.at("seams")) {
    take(entry, sewing.seams.emplace_back());
  }
  for (const Json& list : json.at("bands")) {
    std::vector<scene::BandDescription>& ofCloth = sewing.bands.emplace_back();
    for (const Json& entry : list) {
      take(entry, ofCloth.emplace_back());
    }
  }
}

template <typename T>
void take(const Json& json, T& value) {
  value = json.get<T>();
}

/// Reads a command of that name and its fields.
session::Command readCommand(const std::string& name, const Json& json) {
  std::optional<session::Command> found;
  const auto readIfNamed = [&](const auto& row) {
    if (row.name == name) {
      typename std::decay_t<decltype(row)>::Type command;
      visitFields(command, [&](const char* key, auto& value) { take(json.at(key), value); });
      found = std::move(command);
    }
  };
  std::apply([&](const auto&... rows) { (readIfNamed(rows), ...); }, table);
  if (!found) {
    throw messages::InputError("there is no command '" + name + "'");
  }
  return *std::move(found);
}

template <typename Command>
void writeCommand(const Command& command, Json& json) {
  json["command"] = rowOf<Command>().name;
  visitFields(command, [&](const char* key, const auto& value) { put(json[key], value); });
}

void writeCommand(const session::LoadSceneCommand& /*command*/, Json& /*json*/) {
  throw messages::InputError("a session log holds one scene; it cannot load another");
}

}  // namespace

Json toJson(const session::LoggedCommand& entry) {
  Json json;
  json["step"] = entry.step;
  std::visit([&](const auto& command) { writeCommand(command, json); }, entry.command);
  return json;
}

session::LoggedCommand commandFrom(const Json& json) {
  try {
    const auto step = json.at("step").get<std::int64_t>();
    return {step, readCommand(json.at("command").get<std::string>(), json)};
  } catch (const Json::exception& error) {
    throw messages::InputError("the entry " + json.dump() + " is not a command of a session log");
  }
}

}  // namespace drape::app
