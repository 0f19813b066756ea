#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"
#include "ui/dropped_files.hpp"
#include "ui/ui_output.hpp"

#include <memory>

namespace drape {

/// What the panels are drawn on.
struct UiDisplay {
  int width = 1280;      ///< of the window, in its own units
  int height = 720;      ///< of the window, in its own units
  float density = 1.0F;  ///< framebuffer pixels a window unit; more than 1 on some high-resolution displays
  float scale = 1.0F;    ///< of text and spacing
};

/// The panels: a column of sections at the left, a status line at the bottom, help and error notices over the picture.
/// Reads snapshots, adds to a UiOutput, and needs neither a window nor a simulation. One at a time.
///
/// A frame is build(), then renderDrawData() with the target framebuffer bound. In a window the mouse and the keyboard
/// come from ImGui's GLFW backend, which the viewer attaches; without a window there is no input.
class UserInterface {
 public:
  /// With OpenGl a GlContext must be current from construction to destruction. With None nothing can be drawn, but the
  /// panels can be built and their output looked at.
  enum class Backend { None, OpenGl };

  UserInterface(const UiDisplay& display, Backend backend);
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;
  ~UserInterface();

  /// Before build(). A new scale takes effect once no widget is held, or the held one would move away from the mouse.
  void setDisplay(const UiDisplay& display);

  /// Lays out one frame. What the user does goes to `output`.
  void build(const Snapshot& snapshot, const UiStats& stats, UiOutput& output);

  /// Draws the last frame into the framebuffer that is bound.
  void renderDrawData();

  /// The part of the window that the panels leave for the picture, in window units.
  [[nodiscard]] UiRect view() const;

  /// True when a mouse event at that place belongs to the panels.
  [[nodiscard]] bool covers(const Vec2& point) const;
  /// True while text is being typed, so that keys are no shortcuts.
  [[nodiscard]] bool takesText() const;

  [[nodiscard]] bool panelsVisible() const;
  void showPanels(bool visible);
  [[nodiscard]] bool helpVisible() const;
  void showHelp(bool visible);

  /// Asks which of these files is the cloth; the answer is an OpenPartsRequest.
  void askWhichIsTheCloth(const DroppedFiles& files);

  /// Asks whether to quit although changes are lost; the answer yes is UiAction::QuitAndLoseChanges. Hides another
  /// question until this one is answered.
  void askToQuit();

  /// Takes the questions away without an answer.
  void forgetQuestions();

  /// What the status line said in the last frame, in full.
  [[nodiscard]] const std::string& status() const;

  /// Closes what lies over the picture: a list that dropped down, a question, help, an error. False when there was
  /// nothing.
  bool closeOverlay();

  /// Opens all sections, or closes them all: for pictures and tests.
  void openSections(bool open);

  /// Where each setting's widget was in the last frame, by the setting's key, in window units.
  [[nodiscard]] const UiRects& widgets() const;
  /// Where everything else was that can be clicked: "button.play", "section.air", "wind.dial".
  [[nodiscard]] const UiRects& buttons() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A camera for a picture of the whole window in which the panels cover all but `view`: what the given camera has in
/// the middle appears in the middle of what is left. For pictures in one piece, without a window.
[[nodiscard]] Camera besidePanels(const Camera& camera, const UiRect& view, int width, int height);

/// The scale of text and spacing: what the user set, or what the monitor asks for. Some systems report no scale for a
/// monitor with very many rows, so those get one from their rows.
[[nodiscard]] float uiScale(double fontScaleSetting, float contentScale, int monitorRows);

}  // namespace drape
