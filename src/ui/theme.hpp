#pragma once

#include "ui/theme_choice.hpp"

#include <imgui.h>

#include <array>

namespace drape::ui {

/// The colours of the panels besides ImGui's own style entries.
struct Palette {
  ImVec4 text;
  ImVec4 muted;       ///< labels and explanations
  ImVec4 accent;      ///< active or draggable things
  ImVec4 accentFill;  ///< the filled part of a slider
  ImVec4 accentHovered;
  ImVec4 panel;    ///< background of the column and the status line
  ImVec4 overlay;  ///< background of a box over the picture
  ImVec4 popup;    ///< background of a drop-down list and a tooltip
  ImVec4 field;    ///< background of a widget
  ImVec4 fieldHovered;
  ImVec4 fieldActive;
  ImVec4 button;
  ImVec4 buttonHovered;
  ImVec4 buttonActive;
  ImVec4 heading;  ///< background of a heading under the mouse
  ImVec4 headingActive;
  ImVec4 line;      ///< thin separators
  ImVec4 selected;  ///< background of selected text
  ImVec4 good;
  ImVec4 warning;
  ImVec4 error;
  ImVec4 ghost;                ///< of the second cloth
  std::array<ImVec4, 5> plot;  ///< lines of a plot
};

/// The palette of the theme that applyTheme() chose last for the current ImGui context.
[[nodiscard]] const Palette& palette();

/// Sets spacing, rounding and colours; lengths scale with `scale`.
void applyTheme(ImGuiStyle& style, Theme theme, float scale);

/// The two font sizes.
struct UiFonts {
  ImFont* regular = nullptr;
  ImFont* title = nullptr;
};

/// Rasterises the embedded font into the atlas. `scale` is the size of the text; `density` is the number of pixels per
/// window unit (2 on some high-resolution displays).
[[nodiscard]] UiFonts buildFonts(ImFontAtlas& atlas, float scale, float density);

/// The height of the text at scale 1, in window units.
inline constexpr float baseFontSize = 16.0F;

}  // namespace drape::ui
