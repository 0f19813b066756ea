#pragma once

#include "settings/settings_table.hpp"

#include <map>
#include <string>

namespace drape {

/// Changes that were asked for and have not come back in a snapshot yet. A widget shows what the user chose, not what
/// the simulation used a moment ago; what never comes back (because it was refused) is forgotten after a while.
class PendingSettings {
 public:
  /// `now` is in seconds, on any clock that only grows.
  void add(const SettingInfo& info, const SettingValue& value, double now);

  /// Forgets what has arrived in `current` and what was refused. Changes that need the scene to be built again wait for
  /// as long as it is being built.
  void update(const Settings& current, double now, bool building);

  /// `current` with the waiting changes on top.
  [[nodiscard]] Settings overlay(const Settings& current) const;

  [[nodiscard]] bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    const SettingInfo* info = nullptr;
    SettingValue value;
    double since = 0.0;  ///< [s]
  };
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace drape
