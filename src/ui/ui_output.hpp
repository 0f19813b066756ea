#pragma once

#include "scene/scene_parts.hpp"
#include "session/command.hpp"
#include "settings/settings.hpp"
#include "sim/model/vector.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace drape::ui {

/// A rectangle in window coordinates; (0, 0) is the top left corner of the window.
struct UiRect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  bool visible = true;  ///< false when it is scrolled out of view

  [[nodiscard]] bool contains(const Vec2& point) const {
    return point.x() >= x && point.x() < x + width && point.y() >= y && point.y() < y + height;
  }
};

/// Rectangles by name: settings by key, buttons as "button.play" and the like, sections as "section.air".
using UiRects = std::map<std::string, UiRect>;

/// Open another scene: a built-in name, a scene file or a mesh file.
struct OpenSceneRequest {
  std::string nameOrPath;
};

/// Open a scene that consists of several files.
struct OpenPartsRequest {
  scene::SceneParts parts;
};

/// Files that were dropped on the window together.
struct DroppedRequest {
  std::vector<std::string> files;
};

/// Rebuild the running scene, because a setting that its mesh depends on changed.
struct RebuildSceneRequest {
  settings::Settings settings;  ///< all of them, with the change
};

/// Save a fabric of the user, and give it to the cloth.
struct SaveFabricRequest {
  enum class Place { List, Scene };  ///< the user's list, or the file of the running scene
  settings::OwnFabric fabric;
  Place place = Place::List;
};

/// Actions of the program, not of the simulation.
enum class UiAction {
  TogglePanels,
  ToggleHelp,
  Screenshot,
  FrameCloth,
  ViewFront,
  ViewRight,
  ViewTop,
  ResetAll,           ///< restore settings, pins, bodies and cloth of the scene
  Quit,               ///< or stop reading a file; asks before changes are lost
  CloseWindow,        ///< quit, also while a file is read; asks before changes are lost
  QuitAndLoseChanges  ///< without asking
};

using UiRequest =
    std::variant<OpenSceneRequest, OpenPartsRequest, DroppedRequest, RebuildSceneRequest, SaveFabricRequest, UiAction>;

/// The requests of the user in one frame. Panels and input only add to it; they never change the running state.
struct UiOutput {
  std::vector<session::Command> commands;  ///< for the simulation, in order
  std::vector<UiRequest> requests;         ///< for the program, in order
  std::string hint;                        ///< one sentence for the status line, or empty
};

/// Data of the panels besides the snapshot.
struct UiStats {
  double frameSeconds = 0.0;   ///< between two drawn frames, recently [s]
  std::string loading;         ///< the job in the background, or empty
  double loadingShare = -1.0;  ///< its progress from 0 to 1; negative: unknown
  std::string error;           ///< the last error, in words, or empty
  int failures = 0;            ///< number of errors so far; distinguishes two errors with the same words
  std::string notice;          ///< the last message, or empty
};

}  // namespace drape::ui
