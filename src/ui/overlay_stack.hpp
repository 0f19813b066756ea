#pragma once

#include "ui/panel_context.hpp"

#include <string>

namespace drape::ui {

/// Boxes at the top of the picture, one below the other, so that none covers another, beside the box of a mode. Create
/// one per frame and pass it to everything that shows a box. Permanent boxes come first, so that they do not move when
/// a short message appears.
///
///     stack.begin("reading");
///     ImGui::TextUnformatted("Read as centimetres");
///     stack.end();
class OverlayStack {
 public:
  /// `view` is the part of the window that shows the picture, in window units.
  OverlayStack(PanelContext& context, const UiRect& view);

  /// Whether a box takes the mouse or passes clicks on to the picture behind it.
  enum class Mouse { Taken, LetThrough };

  /// Opens a box below the previous ones. ImGui calls up to end() fill it. Its rectangle is stored as "overlay.NAME",
  /// or as "hint.NAME" when it passes the mouse on.
  void begin(const std::string& name, Mouse mouse = Mouse::Taken);
  void end();

  /// Adds a bar of progress to the open box. @param share that is done, 0 to 1
  void progressBar(double share) const;

  /// Maximum width of a line of text in a box [window units].
  [[nodiscard]] float textWidth() const { return textWidth_; }
  /// Maximum height of the content of the next or the open box [window units].
  [[nodiscard]] float heightBelow() const;

 private:
  PanelContext& context_;
  float bottom_ = 0.0F;     // of the picture [window units]
  float centre_ = 0.0F;     // of all boxes, along x [window units]
  float top_ = 0.0F;        // of the next box [window units]
  float padding_ = 0.0F;    // inside a box, and between two of them [window units]
  float textWidth_ = 0.0F;  // [window units]
};

/// Opens a box at a corner of the picture and stores its rectangle as `name`. endCorner() closes it.
/// @param at a point in window units  @param pivot which point of the box is there: (0, 0) its upper left corner, (1,
/// 1) its lower right one
void beginCorner(PanelContext& context, const std::string& name, const ImVec2& at, const ImVec2& pivot,
                 OverlayStack::Mouse mouse);
void endCorner();

/// Opens the box of a mode at the upper left corner of the picture. The user can drag it elsewhere by its background.
/// It scrolls where the picture is too low for it. endCorner() closes it. @param name one of "overlay.placing",
/// "overlay.selection" and "overlay.sewing"
void beginModeBox(PanelContext& context, const std::string& name, const UiRect& view);

/// The width of what is in the box of a mode, which fits into the picture of a narrow window [window units].
[[nodiscard]] float modeBoxWidth(const PanelContext& context, const UiRect& view);

/// Opens a box in the middle of the picture, with a title, and stores its rectangle as "overlay.NAME". endDialog()
/// closes it.
void beginDialog(PanelContext& context, const UiRect& view, const std::string& name, const Wording& title);
void endDialog();

/// Whether a click hit the picture, not the open dialog. Call it before endDialog().
[[nodiscard]] bool clickedBeside();

}  // namespace drape::ui
