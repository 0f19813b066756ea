#pragma once

#include "locale/language.hpp"
#include "render/camera.hpp"
#include "session/snapshot.hpp"
#include "ui/dropped_files.hpp"
#include "ui/picked_vertices.hpp"
#include "ui/ui_output.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace drape::ui {

/// The size and scale of the drawing area.
struct UiDisplay {
  int width = 1280;      ///< of the window, in its own units
  int height = 720;      ///< of the window, in its own units
  float density = 1.0F;  ///< framebuffer pixels per window unit; more than 1 on some high-resolution displays
  float scale = 1.0F;    ///< of text and spacing
};

/// The panels: a column of sections at the left, a status line at the bottom, help and messages over the picture. It
/// reads snapshots, adds to a UiOutput, and needs neither a window nor a simulation. Only one may exist at a time.
///
/// A frame is build(), then renderDrawData() with the target framebuffer bound. In a window, ImGui's GLFW backend
/// supplies mouse and keyboard; the viewer attaches it. Without a window there is no input.
class UserInterface {
 public:
  /// OpenGl needs a current GlContext from construction to destruction. None cannot draw, but can build the panels for
  /// tests of their output.
  enum class Backend { None, OpenGl };

  UserInterface(const UiDisplay& display, Backend backend);
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;
  ~UserInterface();

  /// Call it before build(). A new scale waits until no widget is active, since it would move away from the mouse.
  void setDisplay(const UiDisplay& display);

  /// Lays out one frame. The user's requests go to `output`.
  void build(const session::Snapshot& snapshot, const UiStats& stats, UiOutput& output);

  /// Draws the last frame into the bound framebuffer.
  void renderDrawData();

  /// A hash of what the last frame draws, never 0. Two frames with the same hash look the same.
  [[nodiscard]] std::uint64_t fingerprint() const;

  /// Draws the legend of the colour map alone into the bound framebuffer of that size [window units]. For a saved
  /// picture; call it between two frames.
  void drawLegend(const session::Snapshot& snapshot, const UiStats& stats, int width, int height);

  /// The part of the window without panels, for the picture [window units].
  [[nodiscard]] UiRect view() const;

  /// Whether a mouse event at that position belongs to the panels.
  [[nodiscard]] bool covers(const Vec2& point) const;
  /// Whether the user is typing text, so that keys are not shortcuts.
  [[nodiscard]] bool takesText() const;

  [[nodiscard]] bool panelsVisible() const;
  void showPanels(bool visible);
  [[nodiscard]] bool helpVisible() const;
  void showHelp(bool visible);

  /// Whether messages, questions and hints are drawn over the picture. Without them and without panels, only the legend
  /// of the colour map is.
  void showNotices(bool visible);

  /// Marks a vertex, or removes its mark. @return false if no more can be marked
  bool pick(int vertex);
  [[nodiscard]] const PickedVertices& picked() const;

  /// Asks which of these files is the cloth; the answer is an OpenPartsRequest.
  void askWhichIsTheCloth(const DroppedFiles& files);
  [[nodiscard]] bool asksWhichIsTheCloth() const;

  /// Asks whether to quit although changes are lost; the answer yes is UiAction::QuitAndLoseChanges. Hides another
  /// question until this one is answered. The export that is under way is named too.
  /// @param hasChanges whether the scene has changes that are not saved
  void askToQuit(bool hasChanges);

  /// Asks whether to replace that scene file; the answer yes is a SaveSceneRequest.
  void askToReplace(const std::string& file);

  /// Opens the search over settings, commands, scenes and the files that were opened before; or closes it.
  void toggleSearch(const std::vector<std::string>& recentFiles);

  /// Shows the field that opens a file, with the keyboard focus.
  void showOpenField();

  /// Opens the section of exports and scrolls to it.
  void showExport();

  void useTheme(Theme theme);
  [[nodiscard]] Theme theme() const;

  /// Shows all texts in that language from the next frame on; at first it is English.
  void useLanguage(const locale::Language& language);
  [[nodiscard]] const locale::Language& language() const;

  /// The sections that the user opened or closed, by title; to be restored before the first frame.
  [[nodiscard]] const std::map<std::string, bool>& sections() const;
  void restoreSections(const std::map<std::string, bool>& sections);

  /// The settings with the user's changes that have not come back in the snapshot yet.
  [[nodiscard]] settings::Settings settingsInForce(const session::Snapshot& snapshot) const;

  /// Whether the user drags or types in the panels, or a change has not come back yet.
  [[nodiscard]] bool isBusy() const;

  /// Closes the questions without an answer.
  void forgetQuestions();

  /// The full text of the status line in the last frame.
  [[nodiscard]] const std::string& status() const;

  /// Closes the topmost thing over the picture: a drop-down list, a question, help, an error. False when there was
  /// none.
  bool closeOverlay();

  /// Opens or closes all sections: for pictures and tests.
  void openSections(bool open);

  /// The rectangles of the setting widgets in the last frame, by key [window units].
  [[nodiscard]] const UiRects& widgets() const;
  /// The rectangles of all other clickable things: "button.play", "section.air", "wind.dial".
  [[nodiscard]] const UiRects& buttons() const;
  /// The rectangles of the labels of rows, by their text in the language of the window.
  [[nodiscard]] const UiRects& labels() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A camera for a picture of the whole window with panels. The centre of the given camera's picture moves to the centre
/// of `view`, the part without panels. For pictures in one piece, without a window.
[[nodiscard]] render::Camera besidePanels(const render::Camera& camera, const UiRect& view, int width, int height);

/// The scale of text and spacing: the user's setting, or the monitor's scale. Some systems report no scale for a
/// monitor with very many rows; its rows then set the scale.
[[nodiscard]] float uiScale(double fontScaleSetting, float contentScale, int monitorRows);

}  // namespace drape::ui
