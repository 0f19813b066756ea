#pragma once

#include "scene/cloth_part.hpp"
#include "scene/toml_text.hpp"
#include "settings/settings_table.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace drape::scene {

/// A value as it is written in a scene file: a number, true or false, or a text in quotes. A short inverse is written
/// as such: "1/300".
[[nodiscard]] std::string valueText(const settings::SettingValue& value);

/// The table [settings] of a scene file with these values.
[[nodiscard]] std::string settingsText(const settings::Settings& settings,
                                       const std::vector<const settings::SettingInfo*>& written);

/// The settings of `target` that a file must write so that it reads back to all of them: those that differ from the
/// defaults, and those that others change, as mass changes mass_given_as.
/// @param read the settings of a file that writes these  Throws InputError when no file has the settings
[[nodiscard]] std::vector<const settings::SettingInfo*> settingsToWrite(
    const settings::Settings& target,
    const std::function<settings::Settings(const std::vector<const settings::SettingInfo*>&)>& read);

/// The fabrics of the user that the settings and the cloths name.
[[nodiscard]] std::vector<settings::OwnFabric> usedFabrics(const settings::Settings& settings,
                                                           std::span<const ClothPart> cloths);

}  // namespace drape::scene
