#include "ui/pending_settings.hpp"

#include <iterator>

namespace drape {
namespace {

constexpr double patience = 1.0;  // [s]

}  // namespace

void PendingSettings::add(const SettingInfo& info, const SettingValue& value, double now) {
  entries_[std::string(info.key)] = Entry{.info = &info, .value = value, .since = now};
}

void PendingSettings::update(const Settings& current, double now, bool building) {
  for (auto item = entries_.begin(); item != entries_.end();) {
    Entry& entry = item->second;
    const bool waits = building && entry.info->effect == SettingEffect::Scene;
    entry.since = waits ? now : entry.since;
    const bool done = settingValue(current, *entry.info) == entry.value || now - entry.since > patience;
    item = done && !waits ? entries_.erase(item) : std::next(item);
  }
}

Settings PendingSettings::overlay(const Settings& current) const {
  Settings settings = current;
  for (const auto& [key, entry] : entries_) {
    assignSetting(settings, *entry.info, entry.value);
  }
  return settings;
}

}  // namespace drape
