#include "ui/change_words.hpp"

#include "settings/own_fabrics.hpp"
#include "settings/surface_fields.hpp"
#include "ui/names_in_words.hpp"
#include "ui/setting_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace drape::ui {
namespace {

using text::Sentence;

std::string shortNumber(double value) {
  return fmt::format("{:.4g}", value);
}

Sentence settingChange(const settings::SettingInfo& info, const settings::Settings& from,
                       const settings::Settings& to) {
  return withUnit(Sentence("{} {} to {}", Sentence(info.title), shownValue(info, from), shownValue(info, to)),
                  info.unit);
}

bool isFabricValue(const settings::SettingInfo& info) {
  const auto isOneOf = [&](std::span<const std::string_view> keys) {
    return std::ranges::find(keys, info.key) != keys.end();
  };
  return isOneOf(settings::fabricValueKeys()) || isOneOf(settings::fabricFrictionKeys());
}

/// Another fabric changes many values, and a changed value makes its name "Cotton, changed". A setting such as mass
/// also sets another one. One of them is enough.
void addSettings(const settings::Settings& from, const settings::Settings& to, std::vector<Sentence>& changes) {
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

void addPins(const session::UserState& from, const session::UserState& to, std::vector<Sentence>& changes) {
  if (session::havePinsInCommon(from, to) || isOtherMesh(from, to)) {
    return;
  }
  const auto count = static_cast<long>(to.pins->size()) - static_cast<long>(from.pins->size());
  if (count == 0) {
    changes.push_back(Sentence("other pins"));
  } else {
    changes.push_back(count > 0 ? Sentence(text::plural(count, "{} pin set", "{} pins set"), count)
                                : Sentence(text::plural(-count, "{} pin released", "{} pins released"), -count));
  }
}

void addPinPaths(const session::UserState& from, const session::UserState& to, std::vector<Sentence>& changes) {
  if (*from.pinPaths != *to.pinPaths && !isOtherMesh(from, to)) {
    changes.push_back(Sentence("keyframes of pins"));
  }
}

std::size_t bandCount(const scene::Sewing& sewing) {
  std::size_t count = 0;
  for (const auto& ofCloth : sewing.bands) {
    count += ofCloth.size();
  }
  return count;
}

void addSewing(const session::UserState& from, const session::UserState& to, std::vector<Sentence>& changes) {
  const scene::Sewing& before = *from.sewing;
  const scene::Sewing& after = *to.sewing;
  const auto add = [&](std::size_t earlier, std::size_t later, const char* added, const char* removed,
                       const char* other) {
    changes.emplace_back(later > earlier ? added : later < earlier ? removed : other);
  };
  if (before.seams != after.seams) {
    add(before.seams.size(), after.seams.size(), "seam added", "seam removed", "other seams");
  }
  if (before.bands != after.bands) {
    add(bandCount(before), bandCount(after), "elastic band added", "elastic band removed", "elastic band changed");
  }
}

void addStart(const session::UserState& from, const session::UserState& to, std::vector<Sentence>& changes) {
  if (!session::haveSameStart(from, to) && from.placements == to.placements && !isOtherMesh(from, to)) {
    changes.push_back(Sentence("dressing"));
  }
}

void addFigure(const std::string& name, const figure::FigureOptions& before, const figure::FigureOptions& after,
               std::vector<Sentence>& changes) {
  if (before.motion != after.motion) {
    changes.push_back(
        Sentence("motion of {} {} to {}", name, Sentence(before.motion->title), Sentence(after.motion->title)));
  }
  if (before.speed != after.speed) {
    changes.push_back(Sentence("speed of {} {} to {}", name, shortNumber(before.speed), shortNumber(after.speed)));
  }
  for (const figure::ProportionInfo& each : figure::proportionTable()) {
    if (before.proportions.*each.value != after.proportions.*each.value) {
      changes.push_back(Sentence("{} of {}", Sentence(each.key), name));
    }
  }
}

void addBodies(const session::UserState& from, const session::UserState& to, const scene::Scene& scene,
               std::vector<Sentence>& changes) {
  const std::size_t count = std::min({from.bodies.size(), to.bodies.size(), scene.bodies->size()});
  for (std::size_t i = 0; i < count; ++i) {
    const session::BodyChoice& before = from.bodies[i];
    const session::BodyChoice& after = to.bodies[i];
    const std::string& name = (*scene.bodies)[i].name;
    if (before.on != after.on) {
      changes.push_back(Sentence(after.on ? "{} switched on" : "{} switched off", name));
    }
    if (before.shift != after.shift) {
      changes.push_back(Sentence("{} moved", name));
    }
    if (before.figure && after.figure) {
      addFigure(name, *before.figure, *after.figure, changes);
    }
    for (const settings::SurfaceField& field : settings::surfaceFields()) {
      if (before.surface.*field.value != after.surface.*field.value) {
        changes.push_back(
            withUnit(Sentence("{} of {} {} to {}", Sentence(field.title), name,
                              shortNumber(before.surface.*field.value), shortNumber(after.surface.*field.value)),
                     field.unit));
      }
    }
  }
}

void addPlacements(const session::UserState& from, const session::UserState& to, const scene::Scene& scene,
                   std::vector<Sentence>& changes) {
  for (const scene::Placeable& thing : scene::placeablesOf(scene.description)) {
    if (from.placements.of(thing) != to.placements.of(thing)) {
      changes.push_back(Sentence("placement of {}", inWords(scene.description, thing)));
    }
  }
  const auto& before = from.placements.readings;
  const auto& after = to.placements.readings;
  for (std::size_t i = 0; i < std::min({before.size(), after.size(), scene.description.bodies.size()}); ++i) {
    if (before[i] != after[i]) {
      changes.push_back(Sentence("unit and up axis of {}", scene.description.bodies[i].body.name));
    }
  }
  const auto& oldClips = from.placements.clips;
  const auto& newClips = to.placements.clips;
  for (std::size_t i = 0; i < std::min({oldClips.size(), newClips.size(), scene.description.bodies.size()}); ++i) {
    if (oldClips[i] != newClips[i]) {
      changes.push_back(Sentence("motion of {}", scene.description.bodies[i].body.name));
    }
  }
}

}  // namespace

Sentence changeInWords(const session::UserState& from, const session::UserState& to, const scene::Scene& scene) {
  std::vector<Sentence> changes;
  addSettings(from.settings, to.settings, changes);
  addPins(from, to, changes);
  addPinPaths(from, to, changes);
  addSewing(from, to, changes);
  addStart(from, to, changes);
  addPlacements(from, to, scene, changes);
  addBodies(from, to, scene, changes);
  constexpr std::size_t shownInFull = 2;
  Sentence words;
  for (std::size_t i = 0; i < std::min(shownInFull, changes.size()); ++i) {
    words.append(", ", changes[i]);
  }
  return changes.size() <= shownInFull ? words : Sentence("{} and {} more", words, changes.size() - shownInFull);
}

}  // namespace drape::ui
