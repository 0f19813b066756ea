#pragma once

#include "settings/settings_table.hpp"

#include <vector>

namespace drape::ui {

/// Changes that have not come back in a snapshot yet. A widget shows the user's choice, not the older value of the
/// simulation. A change that never comes back (it was refused) is dropped after a while.
class PendingSettings {
 public:
  /// `now` is in seconds, from any monotonic clock.
  void add(const settings::SettingInfo& info, const settings::SettingValue& value, double now);

  /// Drops changes that arrived in `current` or were refused. Changes that rebuild the scene wait until it is built.
  void update(const settings::Settings& current, double now, bool building);

  /// `current` with the pending changes applied.
  [[nodiscard]] settings::Settings overlay(const settings::Settings& current) const;

  [[nodiscard]] bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    const settings::SettingInfo* info = nullptr;
    settings::SettingValue value;
    double since = 0.0;  ///< [s]
  };
  std::vector<Entry> entries_;  // the latest choice last
};

}  // namespace drape::ui
