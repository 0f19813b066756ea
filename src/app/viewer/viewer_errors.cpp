// The comparison of the sources of error in the window.
#include "app/viewer/viewer.hpp"
#include "settings/settings_table.hpp"

#include <algorithm>

namespace drape::app {
namespace {

bool moveAlike(const settings::Settings& a, const settings::Settings& b) {
  return std::ranges::all_of(settings::differingSettings(a, b), [](const settings::SettingInfo* info) {
    return info->effect == settings::SettingEffect::View;
  });
}

}  // namespace

void Viewer::compareErrors(const session::Snapshot& snapshot) {
  if (comparison_) {
    return;
  }
  stats_.error = {};
  stats_.errors = {};
  comparedScene_ = snapshot.scene;
  comparedSettings_ = snapshot.settings;
  comparison_ = std::make_unique<ErrorComparison>(snapshot.scene, snapshot.settings);
}

/// Shows how far the comparison is, and its result as long as it is that of this scene and these settings.
void Viewer::followComparison(const session::Snapshot& snapshot) {
  const bool isOld = snapshot.scene != comparedScene_ || !moveAlike(snapshot.settings, comparedSettings_);
  if (isOld) {
    stats_.errors.sources.clear();
  }
  stats_.errors.share.reset();
  if (!comparison_) {
    return;
  }
  if (isOld) {
    comparison_->cancel();
  }
  lastChange_ = Clock::now();
  stats_.errors.share = comparison_->share();
  if (auto outcome = comparison_->poll()) {
    comparison_.reset();
    stats_.errors = {};
    if (!outcome->failure.empty()) {
      showError(outcome->failure);
    } else if (!isOld) {
      stats_.errors.sources = std::move(outcome->sources);
    }
  }
}

}  // namespace drape::app
