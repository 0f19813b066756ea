#pragma once

#include "ui/panel_context.hpp"

#include <string>

namespace drape {

/// Boxes over the top of the picture, one below the other, so that no box covers another. Make one in each frame and
/// give it to everything that has something to say there. What stays for long comes first, so that it does not move
/// when a short message appears.
///
///     stack.begin("reading");
///     ImGui::TextUnformatted("Read as centimetres");
///     stack.end();
class OverlayStack {
 public:
  /// `view` is the part of the window that shows the picture, in window units.
  OverlayStack(PanelContext& context, const UiRect& view);

  /// Whether a box takes the mouse, or lets a click through to the picture behind it.
  enum class Mouse { Taken, LetThrough };

  /// Opens a box below those that are there; ImGui calls up to end() fill it. Its rectangle is remembered as
  /// "overlay.NAME", or as "hint.NAME" when it lets the mouse through.
  void begin(const std::string& name, Mouse mouse = Mouse::Taken);
  void end();

  /// The widest that a line of text in a box may be [window units].
  [[nodiscard]] float textWidth() const { return textWidth_; }
  /// The highest that the content of the next box, or of the one that is open, may be [window units].
  [[nodiscard]] float roomBelow() const;

 private:
  PanelContext& context_;
  float bottom_ = 0.0F;     // of the picture [window units]
  float centre_ = 0.0F;     // of all boxes, along x [window units]
  float top_ = 0.0F;        // of the next box [window units]
  float padding_ = 0.0F;    // inside a box, and between two of them [window units]
  float textWidth_ = 0.0F;  // [window units]
};

/// Opens a box in the middle of the picture, with a title, and remembers its rectangle as "overlay.NAME". It lasts
/// until endDialog().
void beginDialog(PanelContext& context, const UiRect& view, const std::string& name, const std::string& title);
void endDialog();

}  // namespace drape
