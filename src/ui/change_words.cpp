#include "ui/change_words.hpp"

#include "settings/own_fabrics.hpp"
#include "settings/surface_fields.hpp"
#include "ui/setting_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

namespace drape::ui {
namespace {

std::string settingChange(const settings::SettingInfo& info, const settings::Settings& from,
                          const settings::Settings& to) {
  return withUnit(fmt::format("{} {} to {}", info.title, shownValue(info, from), shownValue(info, to)), info.unit);
}

bool isFabricValue(const settings::SettingInfo& info) {
  const auto isOneOf = [&](std::span<const std::string_view> keys) {
    return std::ranges::find(keys, info.key) != keys.end();
  };
  return isOneOf(settings::fabricValueKeys()) || isOneOf(settings::fabricFrictionKeys());
}

/// Another fabric changes many values, and a changed value makes its name "Cotton, changed". A setting such as mass
/// also sets another one. One of them is enough.
void addSettings(const settings::Settings& from, const settings::Settings& to, std::vector<std::string>& changes) {
  const bool otherFabric = from.fabric.preset != to.fabric.preset;
  const std::vector<const settings::SettingInfo*> changed = session::changedSettings(from, to);
  for (const settings::SettingInfo* info : changed) {
    const bool ofFabric = otherFabric ? isFabricValue(*info) : info->isPreset;
    const bool follows =
        std::ranges::any_of(changed, [&](const settings::SettingInfo* other) { return other->alsoKey == info->key; });
    const bool hidden = !settings::isRelevant(*info, from) && !settings::isRelevant(*info, to);
    if (!ofFabric && !follows && !hidden) {
      changes.push_back(settingChange(*info, from, to));
    }
  }
}

/// Another mesh numbers its vertices anew, so its pins cannot be compared.
bool isOtherMesh(const session::UserState& from, const session::UserState& to) {
  return std::ranges::any_of(
      session::changedSettings(from.settings, to.settings),
      [](const settings::SettingInfo* info) { return info->effect == settings::SettingEffect::Scene; });
}

void addPins(const session::UserState& from, const session::UserState& to, std::vector<std::string>& changes) {
  if (session::havePinsInCommon(from, to) || isOtherMesh(from, to)) {
    return;
  }
  const auto count = static_cast<long>(to.pins->size()) - static_cast<long>(from.pins->size());
  changes.push_back(count == 0 ? std::string("other pins")
                               : fmt::format("{} {} {}", std::abs(count), std::abs(count) == 1 ? "pin" : "pins",
                                             count > 0 ? "set" : "released"));
}

void addPinPaths(const session::UserState& from, const session::UserState& to, std::vector<std::string>& changes) {
  if (*from.pinPaths != *to.pinPaths && !isOtherMesh(from, to)) {
    changes.emplace_back("keyframes of pins");
  }
}

void addFigure(const std::string& name, const figure::FigureOptions& before, const figure::FigureOptions& after,
               std::vector<std::string>& changes) {
  if (before.motion != after.motion) {
    changes.push_back(fmt::format("motion of {} {} to {}", name, before.motion->title, after.motion->title));
  }
  if (before.speed != after.speed) {
    changes.push_back(fmt::format("speed of {} {:.4g} to {:.4g}", name, before.speed, after.speed));
  }
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (before.proportions.*each.value != after.proportions.*each.value) {
      changes.push_back(fmt::format("{} of {}", each.key, name));
    }
  }
}

void addBodies(const session::UserState& from, const session::UserState& to, const scene::Scene& scene,
               std::vector<std::string>& changes) {
  const std::size_t count = std::min({from.bodies.size(), to.bodies.size(), scene.bodies->size()});
  for (std::size_t i = 0; i < count; ++i) {
    const session::BodyChoice& before = from.bodies[i];
    const session::BodyChoice& after = to.bodies[i];
    const std::string& name = (*scene.bodies)[i].name;
    if (before.on != after.on) {
      changes.push_back(name + (after.on ? " switched on" : " switched off"));
    }
    if (before.shift != after.shift) {
      changes.push_back(name + " moved");
    }
    if (before.figure && after.figure) {
      addFigure(name, *before.figure, *after.figure, changes);
    }
    for (const settings::SurfaceField& field : settings::surfaceFields()) {
      if (before.surface.*field.value != after.surface.*field.value) {
        changes.push_back(withUnit(fmt::format("{} of {} {:.4g} to {:.4g}", field.title, name,
                                               before.surface.*field.value, after.surface.*field.value),
                                   field.unit));
      }
    }
  }
}

void addPlacements(const session::UserState& from, const session::UserState& to, const scene::Scene& scene,
                   std::vector<std::string>& changes) {
  for (const scene::Placeable& thing : scene::placeablesOf(scene.description)) {
    if (from.placements.of(thing) != to.placements.of(thing)) {
      changes.push_back("placement of the " + scene::nameOf(scene.description, thing));
    }
  }
}

}  // namespace

std::string changeInWords(const session::UserState& from, const session::UserState& to, const scene::Scene& scene) {
  std::vector<std::string> changes;
  addSettings(from.settings, to.settings, changes);
  addPins(from, to, changes);
  addPinPaths(from, to, changes);
  addPlacements(from, to, scene, changes);
  addBodies(from, to, scene, changes);
  constexpr std::size_t shownInFull = 2;
  std::string words;
  for (std::size_t i = 0; i < std::min(shownInFull, changes.size()); ++i) {
    words += (i == 0 ? "" : ", ") + changes[i];
  }
  return changes.size() <= shownInFull ? words : fmt::format("{} and {} more", words, changes.size() - shownInFull);
}

}  // namespace drape::ui
