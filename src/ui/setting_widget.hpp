#pragma once

#include "settings/settings_table.hpp"
#include "ui/panel_context.hpp"

namespace drape::ui {

/// Draws the row of one setting from its entry in the settings table: a slider, a check box or a choice of words, with
/// range, unit and an explanation on hovering. A change becomes a command or, when the mesh depends on it, a request to
/// rebuild the scene. A right click restores the scene's value, another one the default.
void settingWidget(PanelContext& context, const settings::SettingInfo& info);

/// Draws all settings of a group that apply now, in the order of the table.
void settingsOfGroup(PanelContext& context, settings::SettingGroup group);

/// Whether a setting applies to the running scene. A grid's settings do not apply to a mesh file, nor a mesh file's to
/// a grid; mass does not apply while the density is given.
[[nodiscard]] bool settingApplies(const settings::SettingInfo& info, const settings::Settings& settings,
                                  const scene::Scene& scene);

/// Requests a change, as a command or a rebuild. A value that the setting refuses is dropped.
void changeSetting(PanelContext& context, const settings::SettingInfo& info, const settings::SettingValue& value);

}  // namespace drape::ui
