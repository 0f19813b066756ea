#pragma once

#include "scene/scene_parts.hpp"
#include "session/command.hpp"
#include "settings/settings.hpp"
#include "sim/vector.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace drape {

/// A rectangle in window coordinates; (0, 0) is the top left corner of the window.
struct UiRect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
  bool visible = true;  ///< false when it is scrolled out of sight

  [[nodiscard]] bool contains(const Vec2& point) const {
    return point.x() >= x && point.x() < x + width && point.y() >= y && point.y() < y + height;
  }
};

/// Rectangles by name: settings by their key, buttons by "button.play" and the like, sections by "section.air".
using UiRects = std::map<std::string, UiRect>;

/// Open another scene: a built-in name, a scene file or a mesh file.
struct OpenSceneRequest {
  std::string nameOrPath;
};

/// Open a scene that is put together from several files.
struct OpenPartsRequest {
  SceneParts parts;
};

/// Files that were dropped on the window together.
struct DroppedRequest {
  std::vector<std::string> files;
};

/// Build the running scene again because a setting changed that its mesh depends on.
struct RebuildSceneRequest {
  Settings settings;  ///< all of them, with the change
};

/// What the program itself does, rather than the simulation.
enum class UiAction {
  TogglePanels,
  ToggleHelp,
  Screenshot,
  FrameCloth,
  ViewFront,
  ViewRight,
  ViewTop,
  ResetAll,           ///< settings, pins, bodies and the cloth, as the scene has them
  Quit,               ///< or stop reading a file; asks first where changes would be lost
  CloseWindow,        ///< quit, also while a file is read; asks first where changes would be lost
  QuitAndLoseChanges  ///< without a question
};

using UiRequest = std::variant<OpenSceneRequest, OpenPartsRequest, DroppedRequest, RebuildSceneRequest, UiAction>;

/// Everything the user asked for during one frame. Panels and input only ever add to this; nobody changes live state.
struct UiOutput {
  std::vector<Command> commands;    ///< for the simulation, in order
  std::vector<UiRequest> requests;  ///< for the program, in order
  std::string hint;                 ///< a sentence for the status line, or empty
};

/// What the panels show besides the snapshot.
struct UiStats {
  double frameSeconds = 0.0;   ///< from one drawn frame to the next, lately [s]
  std::string loading;         ///< what is being built in the background, or empty
  double loadingShare = -1.0;  ///< how much of it is done, from 0 to 1; negative: not known
  std::string error;           ///< the last thing that failed, in words, or empty
  int failures = 0;            ///< how many things have failed; tells two errors of the same words apart
  std::string notice;          ///< the last thing worth telling, or empty
};

}  // namespace drape
