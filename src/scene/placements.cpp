#include "scene/placements.hpp"

#include "messages/error.hpp"
#include "scene/toml_reader.hpp"
#include "settings/settings_table.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <iterator>
#include <variant>

namespace drape::scene {
namespace {

void requireAllowed(const Placement& placement) {
  if (!isAllowed(placement)) {
    throw messages::InputError(
        fmt::format("a placement needs a position of at most {} m, a finite rotation and a scale from {} to {}",
                    farAway, minPlacementScale, maxPlacementScale));
  }
}

/// A session log may have anything.
void requireReading(const ReadingChoice& reading) {
  try {
    settings::Settings settings;
    settings::assignSettingText(settings, settings::requireSetting("unit"), reading.unit);
    settings::assignSettingText(settings, settings::requireSetting("up"), reading.up);
  } catch (const messages::UsageError& error) {
    throw messages::InputError(error.what());
  }
}

/// Sets the placements of all cloths, or of all bodies.
template <typename Description>
void assign(const std::vector<Placement>& placements, std::vector<Description>& descriptions, const char* what) {
  if (placements.size() != descriptions.size()) {
    throw messages::InputError(fmt::format("there are {} placements of {}, but the scene has {} of them",
                                           placements.size(), what, descriptions.size()));
  }
  for (std::size_t i = 0; i < placements.size(); ++i) {
    requireAllowed(placements[i]);
    descriptions[i].placement = placements[i];
  }
}

/// The clips of all bodies. @param of a member of AnimationSource
std::vector<std::optional<std::string>> clipsOf(const std::vector<BodyDescription>& bodies,
                                                std::string AnimationSource::*of) {
  std::vector<std::optional<std::string>> clips;
  for (const BodyDescription& body : bodies) {
    clips.push_back(body.animation ? std::optional((*body.animation).*of) : std::nullopt);
  }
  return clips;
}

}  // namespace

bool isAllowed(const Placement& placement) {
  return placement.position.allFinite() && placement.position.cwiseAbs().maxCoeff() <= farAway &&
         placement.rotation.allFinite() && placement.scale >= minPlacementScale && placement.scale <= maxPlacementScale;
}

const Placement& Placements::of(const Placeable& thing) const& {
  return thing.kind == Placeable::Kind::Cloth ? cloths.at(thing.index) : bodies.at(thing.index);
}

Placement& Placements::of(const Placeable& thing) & {
  return thing.kind == Placeable::Kind::Cloth ? cloths.at(thing.index) : bodies.at(thing.index);
}

Placements placementsOf(const SceneDescription& description) {
  Placements all;
  std::ranges::transform(description.cloths, std::back_inserter(all.cloths), &ClothDescription::placement);
  std::ranges::transform(description.bodies, std::back_inserter(all.bodies), &BodyDescription::placement);
  std::ranges::transform(description.bodies, std::back_inserter(all.readings), &BodyDescription::reading);
  all.clips = clipsOf(description.bodies, &AnimationSource::clip);
  return all;
}

Placements writtenPlacementsOf(const SceneDescription& description) {
  Placements all;
  std::ranges::transform(description.cloths, std::back_inserter(all.cloths), &ClothDescription::writtenPlacement);
  std::ranges::transform(description.bodies, std::back_inserter(all.bodies), &BodyDescription::writtenPlacement);
  std::ranges::transform(description.bodies, std::back_inserter(all.readings), &BodyDescription::openedReading);
  all.clips = clipsOf(description.bodies, &AnimationSource::openedClip);
  return all;
}

SceneDescription withPlacements(SceneDescription description, const Placements& placements) {
  assign(placements.cloths, description.cloths, "cloths");
  assign(placements.bodies, description.bodies, "bodies");
  for (std::size_t i = 0; i < std::min(placements.readings.size(), description.bodies.size()); ++i) {
    if (placements.readings[i]) {
      requireReading(*placements.readings[i]);
    }
    description.bodies[i].reading = placements.readings[i];
  }
  for (std::size_t i = 0; i < std::min(placements.clips.size(), description.bodies.size()); ++i) {
    std::optional<AnimationSource>& animation = description.bodies[i].animation;
    if (animation && placements.clips[i]) {
      animation->clip = *placements.clips[i];
    }
  }
  return description;
}

std::vector<Placeable> placeablesOf(const SceneDescription& description) {
  std::vector<Placeable> all;
  for (std::size_t i = 0; i < description.cloths.size(); ++i) {
    all.push_back({Placeable::Kind::Cloth, i});
  }
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    all.push_back({Placeable::Kind::Body, i});
  }
  return all;
}

std::string nameOf(const SceneDescription& description, const Placeable& thing) {
  if (thing.kind == Placeable::Kind::Body) {
    return description.bodies.at(thing.index).body.name;
  }
  const std::string& name = description.cloths.at(thing.index).name;
  return name.empty() ? "cloth" : name;
}

bool isPlane(const SceneDescription& description, const Placeable& thing) {
  if (thing.kind == Placeable::Kind::Cloth) {
    return false;
  }
  const BodyDescription& body = description.bodies.at(thing.index);
  return body.meshes.empty() && std::holds_alternative<sim::contact::PlaneShape>(body.body.shape);
}

std::string whyNotScaled(const SceneDescription& description, const Placeable& thing) {
  if (thing.kind == Placeable::Kind::Body && description.bodies.at(thing.index).figure) {
    return "A figure has its size by its measures, in the section Scene.";
  }
  return isPlane(description, thing) ? "A plane is infinite, so it has no scale." : std::string();
}

}  // namespace drape::scene
