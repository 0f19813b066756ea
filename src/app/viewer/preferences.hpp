#pragma once

#include "scene/scene.hpp"
#include "ui/theme_choice.hpp"
#include "ui/ui_output.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace drape::app {

/// The place of the window on the desktop [window units].
struct WindowPlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const WindowPlace&) const = default;
};

/// The kept views of a scene.
struct SceneViews {
  std::string scene;  ///< its name, or the absolute path of its file
  std::array<std::optional<scene::CameraPose>, ui::keptViewCount> views;

  bool operator==(const SceneViews&) const = default;
};

/// What the window keeps from one start to the next.
struct Preferences {
  std::optional<WindowPlace> window;
  ui::Theme theme = ui::Theme::Dark;
  std::string language;                  ///< that the user chose; empty: none, that of the system
  std::string folder;                    ///< of the last opened or saved file; empty: none
  std::vector<std::string> recentFiles;  ///< that were opened, the newest first; absolute paths
  std::map<std::string, bool> sections;  ///< by title, whether the user opened or closed them

  std::vector<SceneViews> views;  ///< the scene whose views changed last comes first

  bool operator==(const Preferences&) const = default;

  /// The views of a scene; null if there are none.
  [[nodiscard]] const SceneViews* viewsOf(const std::string& scene) const;
  /// Keeps a view in one of the places of a scene.
  void keepView(const std::string& scene, std::size_t place, const scene::CameraPose& view);

  /// Puts a file at the front of recentFiles.
  void noteFile(const std::filesystem::path& file);

  static constexpr std::size_t maxRecentFiles = 10;
  static constexpr std::size_t maxScenesWithViews = 50;
};

/// The file with the preferences: window.json in $XDG_STATE_HOME/drape, else in ~/.local/state/drape. Empty where the
/// environment names no such folder.
[[nodiscard]] std::filesystem::path usualPreferencesFile();

/// The text of a file with these preferences, and the preferences of a text. preferencesFrom throws InputError when the
/// text is damaged.
[[nodiscard]] std::string preferencesText(const Preferences& preferences);
[[nodiscard]] Preferences preferencesFrom(const std::string& text);

/// The preferences and their file.
class PreferencesFile {
 public:
  /// Reads the file. One that does not exist has the usual values. @param file empty: none is read or written
  explicit PreferencesFile(std::filesystem::path file);

  /// As they were read or written last.
  [[nodiscard]] const Preferences& values() const { return values_; }

  /// What is wrong with the file, in one line; empty if nothing is. Such a file is ignored, and replaced when the user
  /// changes a preference.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// Writes the preferences beside the old file and renames it, if they differ from values(). @return what failed, in
  /// one line, the first time; otherwise empty
  [[nodiscard]] std::string keep(const Preferences& preferences);

 private:
  std::filesystem::path file_;
  Preferences values_;
  std::string problem_;
  bool failed_ = false;
};

}  // namespace drape::app
