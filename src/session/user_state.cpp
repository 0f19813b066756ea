#include "session/user_state.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace drape::session {
namespace {

/// Whether the simulation itself changes auto.cost.
bool adaptsCost(const settings::Settings& settings) {
  return settings.automatic.budget > 0.0;
}

std::vector<int> verticesOf(const std::vector<PinPlace>& pins) {
  std::vector<int> vertices;
  vertices.reserve(pins.size());
  std::ranges::transform(pins, std::back_inserter(vertices), &PinPlace::vertex);
  return vertices;
}

/// Whether a body or keyframes move a pin.
bool isCarried(int vertex, const scene::Scene& scene, const std::vector<scene::PinPath>& paths) {
  if (std::ranges::any_of(paths, [&](const scene::PinPath& path) {
        return std::ranges::find(path.vertices, vertex) != path.vertices.end();
      })) {
    return true;
  }
  return std::ranges::any_of(*scene.bodies, [&](const sim::contact::Body& body) {
    return std::ranges::any_of(body.pins, [&](const sim::contact::CarriedPin& pin) { return pin.vertex == vertex; });
  });
}

void addPinCommands(const UserState& from, const UserState& to, const scene::Scene& scene,
                    std::vector<Command>& commands) {
  if (havePinsInCommon(from, to)) {
    return;
  }
  const std::vector<int> before = verticesOf(*from.pins);
  PlacePinsCommand places;
  for (const PinPlace& pin : *to.pins) {
    if (!std::ranges::binary_search(before, pin.vertex) && !isCarried(pin.vertex, scene, *to.pinPaths)) {
      places.vertices.push_back(pin.vertex);
      places.places.push_back(pin.place);
    }
  }
  commands.emplace_back(SetPinsCommand{verticesOf(*to.pins)});
  if (!places.vertices.empty()) {
    commands.emplace_back(std::move(places));
  }
}

void addBodyCommands(const UserState& from, const UserState& to, std::vector<Command>& commands) {
  const std::size_t count = std::min(from.bodies.size(), to.bodies.size());
  for (std::size_t i = 0; i < count; ++i) {
    const BodyChoice& wanted = to.bodies[i];
    const int body = static_cast<int>(i);
    if (from.bodies[i].on != wanted.on) {
      commands.emplace_back(SwitchBodyCommand{body, wanted.on});
    }
    if (from.bodies[i].surface != wanted.surface) {
      commands.emplace_back(SetSurfaceCommand{body, wanted.surface});
    }
    if (from.bodies[i].shift != wanted.shift) {
      commands.emplace_back(MoveBodyCommand{body, wanted.shift});
    }
    if (wanted.figure && from.bodies[i].figure != wanted.figure) {
      commands.emplace_back(SetFigureCommand{body, *wanted.figure});
    }
  }
}

}  // namespace

std::shared_ptr<const std::vector<PinPlace>> pinsOf(const Snapshot& snapshot) {
  auto pins = std::make_shared<std::vector<PinPlace>>();
  const std::vector<bool>& pinned = snapshot.model->pinned;
  for (std::size_t v = 0; v < pinned.size(); ++v) {
    if (pinned[v]) {
      pins->push_back({static_cast<int>(v), snapshot.positions[v]});
    }
  }
  return pins;
}

UserState userStateOf(const Snapshot& snapshot, std::shared_ptr<const std::vector<PinPlace>> pins) {
  UserState state{
      snapshot.settings, std::move(pins),     {}, snapshot.pinPaths, scene::placementsOf(snapshot.scene->description),
      snapshot.sewing,   snapshot.placedStart};
  for (const BodyStatus& body : snapshot.bodies) {
    state.bodies.push_back({body.on, body.targetShift, body.surface, body.figure});
  }
  return state;
}

UserState userStateOf(const Snapshot& snapshot) {
  return userStateOf(snapshot, pinsOf(snapshot));
}

std::vector<const settings::SettingInfo*> changedSettings(const settings::Settings& a, const settings::Settings& b) {
  std::vector<const settings::SettingInfo*> changed = settings::differingSettings(a, b);
  if (adaptsCost(a) || adaptsCost(b)) {
    std::erase(changed, settings::findSetting("auto.cost"));
  }
  return changed;
}

bool havePinsInCommon(const UserState& a, const UserState& b) {
  return std::ranges::equal(*a.pins, *b.pins, {}, &PinPlace::vertex, &PinPlace::vertex);
}

bool haveSameStart(const UserState& a, const UserState& b) {
  return a.placedStart == b.placedStart || (a.placedStart && b.placedStart && *a.placedStart == *b.placedStart);
}

bool areSame(const UserState& a, const UserState& b) {
  return a.bodies == b.bodies && a.placements == b.placements && havePinsInCommon(a, b) && *a.pinPaths == *b.pinPaths &&
         *a.sewing == *b.sewing && haveSameStart(a, b) && changedSettings(a.settings, b.settings).empty();
}

std::vector<Command> runningChanges(const settings::Settings& from, const settings::Settings& to) {
  const auto values = settings::fabricValueKeys();
  bool otherFabric = false;
  std::vector<Command> changes;
  for (const settings::SettingInfo* info : settings::differingSettings(from, to)) {
    if (info->isPreset || std::find(values.begin(), values.end(), info->key) != values.end()) {
      otherFabric = true;
    } else if (info->effect != settings::SettingEffect::Scene) {
      changes.emplace_back(SetSettingCommand{std::string(info->key), settings::settingValue(to, *info)});
    }
  }
  if (otherFabric) {
    changes.emplace_back(UseFabricCommand{settings::fabricOf(to, to.fabric.preset)});
    for (const std::string_view key : settings::fabricFrictionKeys()) {  // which the fabric sets
      changes.emplace_back(
          SetSettingCommand{std::string(key), settings::settingValue(to, settings::requireSetting(key))});
    }
  }
  return changes;
}

std::vector<Command> settingCommands(const settings::Settings& from, const settings::Settings& to) {
  settings::Settings wanted = to;
  if (adaptsCost(from) || adaptsCost(to)) {
    wanted.step.automatic.costBudget = from.step.automatic.costBudget;
  }
  return runningChanges(from, wanted);
}

std::vector<Command> commandsBetween(const UserState& from, const UserState& to, const scene::Scene& scene) {
  std::vector<Command> commands = settingCommands(from.settings, to.settings);
  if (*from.sewing != *to.sewing) {
    commands.emplace_back(SetSewingCommand{*to.sewing});
  }
  addPinCommands(from, to, scene, commands);
  if (*from.pinPaths != *to.pinPaths) {
    commands.emplace_back(SetPinPathsCommand{*to.pinPaths});
  }
  addBodyCommands(from, to, commands);
  if (!haveSameStart(from, to)) {
    commands.emplace_back(PlaceClothCommand{to.placedStart ? *to.placedStart : std::vector<Vec3>(), true});
  }
  return commands;
}

bool changesUserState(const Command& command) {
  return std::visit(
      [](const auto& each) {
        using Type = std::decay_t<decltype(each)>;
        return std::is_same_v<Type, SetSettingCommand> || std::is_same_v<Type, UseFabricCommand> ||
               std::is_same_v<Type, TogglePinCommand> || std::is_same_v<Type, SetPinsCommand> ||
               std::is_same_v<Type, SetPinPathsCommand> || std::is_same_v<Type, SetSewingCommand> ||
               std::is_same_v<Type, SwitchBodyCommand> || std::is_same_v<Type, SetSurfaceCommand> ||
               std::is_same_v<Type, MoveBodyCommand> || std::is_same_v<Type, SetFigureCommand>;
      },
      command);
}

}  // namespace drape::session
