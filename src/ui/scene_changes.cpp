#include "ui/scene_changes.hpp"

#include "settings/settings_table.hpp"

#include <algorithm>
#include <vector>

namespace drape {
namespace {

/// Ignores settings without effect: some follow from others.
bool settingsDiffer(const Settings& one, const Settings& other, bool alsoView) {
  const std::vector<const SettingInfo*> differing = differingSettings(one, other);
  return std::any_of(differing.begin(), differing.end(), [&](const SettingInfo* info) {
    return (alsoView || info->effect != SettingEffect::View) && isRelevant(*info, one);
  });
}

bool bodiesDiffer(const Snapshot& snapshot) {
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    const BodyStatus& status = snapshot.bodies[i];
    if (!status.on || !status.shift.isZero() || status.surface != (*snapshot.scene->bodies)[i].surface) {
      return true;
    }
  }
  return false;
}

bool pinsOrBodiesDiffer(const Snapshot& snapshot) {
  return snapshot.model->pinned != snapshot.scene->model->pinned || bodiesDiffer(snapshot);
}

}  // namespace

bool hasChanges(const Snapshot& snapshot, const Scene& opened) {
  return settingsDiffer(snapshot.settings, opened.settings, false) || pinsOrBodiesDiffer(snapshot);
}

bool differsFromScene(const Snapshot& snapshot, const Settings& inForce) {
  return settingsDiffer(inForce, snapshot.scene->description.settings, true) || pinsOrBodiesDiffer(snapshot);
}

}  // namespace drape
