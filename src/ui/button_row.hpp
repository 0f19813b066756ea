#pragma once

#include "ui/panel_context.hpp"

#include <initializer_list>

namespace drape::ui {

/// Buttons of equal width side by side, in as many lines as they need.
class ButtonRow {
 public:
  /// @param width of the row [window units]  @param words of its buttons, so that each of them fits
  ButtonRow(const PanelContext& context, float width, std::initializer_list<const char*> words);

  /// A button that may be disabled. Its rectangle is stored as "button.NAME". @return whether it was pressed
  bool button(PanelContext& context, const char* name, const char* word, bool isEnabled = true, bool strong = false);

 private:
  float right_ = 0.0F;  // of the row [window units]
  float width_ = 0.0F;  // of a button [window units]
  bool isFollowing_ = false;
};

}  // namespace drape::ui
