#pragma once

#include "scene/scene.hpp"
#include "settings/settings_table.hpp"
#include "text/catalogue.hpp"
#include "ui/shortcuts.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace drape::ui {

/// A built-in scene, or a file that was opened before.
struct SceneTarget {
  std::string nameOrPath;
};

/// Something that the search finds: a command, a setting or a scene.
struct SearchEntry {
  std::string title;  ///< "Stiffness", "Save a picture", "A flag in the wind", in the language of the window
  std::string key;    ///< of a setting or a scene; the keys of a command
  std::string help;   ///< in one or more sentences
  std::variant<const Shortcut*, const settings::SettingInfo*, SceneTarget> target;
  std::string english = {};      ///< the title in English, which is found too
  std::string englishHelp = {};  ///< the same of the help
};

/// All commands, settings and scenes, from their tables.
/// @param files that were opened before, the newest first  @param texts of the language of the window
[[nodiscard]] std::vector<SearchEntry> searchEntries(std::span<const scene::SceneInfo> scenes,
                                                     std::span<const std::string> files,
                                                     const text::Catalogue& texts = text::Catalogue());

/// How well an entry fits a text; less is better. Every word of the text must occur: at the start of a word of the
/// title, anywhere in title, key or help, or with its letters spread over the title. Short titles are better. Title and
/// help count in the language of the window and in English. Empty if the entry does not fit.
[[nodiscard]] std::optional<int> misfit(const SearchEntry& entry, std::string_view text);

/// The indices of the entries that fit, the best first. Equal ones keep their order.
[[nodiscard]] std::vector<std::size_t> findEntries(std::span<const SearchEntry> entries, std::string_view text);

}  // namespace drape::ui
