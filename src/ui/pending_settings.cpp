#include "ui/pending_settings.hpp"

#include "messages/error.hpp"

namespace drape::ui {
namespace {

constexpr double patience = 1.0;  // [s]

}  // namespace

void PendingSettings::add(const settings::SettingInfo& info, const settings::SettingValue& value, double now) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.info == &info; });
  entries_.push_back({.info = &info, .value = value, .since = now});
}

void PendingSettings::update(const settings::Settings& current, double now, bool building) {
  const auto waits = [&](const Entry& entry) {
    return building && entry.info->effect == settings::SettingEffect::Scene;
  };
  for (Entry& entry : entries_) {
    entry.since = waits(entry) ? now : entry.since;
  }
  std::erase_if(entries_, [&](const Entry& entry) {
    const bool done = settings::settingValue(current, *entry.info) == entry.value || now - entry.since > patience;
    return done && !waits(entry);
  });
}

settings::Settings PendingSettings::overlay(const settings::Settings& current) const {
  settings::Settings settings = current;
  for (const Entry& entry : entries_) {
    try {
      settings::assignSetting(settings, *entry.info, entry.value);
    } catch (const messages::UsageError&) {
      continue;  // a fabric of the previous scene, which this scene does not have
    }
  }
  return settings;
}

}  // namespace drape::ui
