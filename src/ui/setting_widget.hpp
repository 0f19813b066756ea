#pragma once

#include "settings/settings_table.hpp"
#include "ui/panel_context.hpp"

#include <string>

namespace drape {

/// Draws the row for one setting, made from its entry in the settings table alone: a slider, a box to tick or a choice
/// of words, with range, unit and an explanation that appears on hovering. A change becomes a command (or, when the
/// mesh depends on it, a request to build the scene again); a right click restores the scene's value.
void settingWidget(PanelContext& context, const SettingInfo& info);

/// Draws every setting of a group, in the table's order, except those that do not apply now.
void settingsOfGroup(PanelContext& context, SettingGroup group);

/// False for a setting that has no meaning for the running scene: a grid's for a mesh file, a mesh file's for a grid,
/// and one of two ways to say the same thing while the other is in use (mass while the density is given).
[[nodiscard]] bool settingApplies(const SettingInfo& info, const Settings& settings, const Scene& scene);

/// Asks for a change, in whichever way the setting needs. A value that the setting refuses is dropped.
void changeSetting(PanelContext& context, const SettingInfo& info, const SettingValue& value);

/// A number's format for printf with its unit: "%.4g m/s".
[[nodiscard]] std::string numberFormat(std::string_view digits, std::string_view unit);

}  // namespace drape
