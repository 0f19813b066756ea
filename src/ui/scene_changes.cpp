#include "ui/scene_changes.hpp"

#include "settings/settings_table.hpp"

#include <algorithm>
#include <vector>

namespace drape::ui {
namespace {

/// Ignores settings without effect: some follow from others.
bool settingsDiffer(const settings::Settings& one, const settings::Settings& other, bool alsoView) {
  const std::vector<const settings::SettingInfo*> differing = settings::differingSettings(one, other);
  return std::any_of(differing.begin(), differing.end(), [&](const settings::SettingInfo* info) {
    return (alsoView || info->effect != settings::SettingEffect::View) && settings::isRelevant(*info, one);
  });
}

bool isOtherFigure(const session::Snapshot& snapshot, std::size_t body) {
  const auto& described = snapshot.scene->description.bodies;  // without the stand and the ground
  return body < described.size() && snapshot.bodies[body].figure != described[body].figure;
}

bool bodiesDiffer(const session::Snapshot& snapshot) {
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    const session::BodyStatus& status = snapshot.bodies[i];
    if (isOtherFigure(snapshot, i) || !status.on || !status.shift.isZero() ||
        status.surface != (*snapshot.scene->bodies)[i].surface) {
      return true;
    }
  }
  return false;
}

bool isPlaced(const scene::SceneDescription& description) {
  return scene::placementsOf(description) != scene::writtenPlacementsOf(description);
}

bool pinsOrBodiesDiffer(const session::Snapshot& snapshot) {
  return snapshot.model->pinned != snapshot.scene->model->pinned || *snapshot.pinPaths != snapshot.scene->pinPaths ||
         *snapshot.sewing != scene::sewingOf(snapshot.scene->description) || bodiesDiffer(snapshot) ||
         isPlaced(snapshot.scene->description);
}

}  // namespace

bool hasChanges(const session::Snapshot& snapshot, const scene::Scene& opened) {
  return settingsDiffer(snapshot.settings, opened.settings, false) || pinsOrBodiesDiffer(snapshot);
}

bool hasChanges(const session::UserState& now, const session::UserState& saved) {
  return now.bodies != saved.bodies || now.placements != saved.placements || !session::havePinsInCommon(now, saved) ||
         *now.pinPaths != *saved.pinPaths || *now.sewing != *saved.sewing ||
         settingsDiffer(now.settings, saved.settings, false);
}

bool differsFromScene(const session::Snapshot& snapshot, const settings::Settings& inForce) {
  return settingsDiffer(inForce, snapshot.scene->description.settings, true) || pinsOrBodiesDiffer(snapshot);
}

}  // namespace drape::ui
