#pragma once

#include <imgui.h>

#include <array>

namespace drape {

/// The colours that the panels use beyond ImGui's own style entries.
struct Palette {
  ImVec4 text;
  ImVec4 muted;       ///< labels and explanations
  ImVec4 accent;      ///< what is on, or can be dragged
  ImVec4 accentFill;  ///< the filled part of a slider
  ImVec4 panel;       ///< background of the column and the status line
  ImVec4 field;       ///< background of a widget
  ImVec4 line;        ///< thin separators
  ImVec4 good;
  ImVec4 warning;
  ImVec4 error;
  ImVec4 ghost;                ///< what belongs to the second cloth
  std::array<ImVec4, 5> plot;  ///< lines of a plot, told apart
};

/// The dark palette of the program.
[[nodiscard]] const Palette& palette();

/// Spacing, rounding and colours; lengths grow with `scale`.
void applyTheme(ImGuiStyle& style, float scale);

/// The two sizes of the typeface.
struct UiFonts {
  ImFont* regular = nullptr;
  ImFont* title = nullptr;
};

/// Puts the embedded typeface into the atlas and rasterises it. `scale` is the size of the text; `density` is how many
/// pixels make up a window unit (2 on some high-resolution displays).
[[nodiscard]] UiFonts buildFonts(ImFontAtlas& atlas, float scale, float density);

/// The height of the text at scale 1, in window units.
inline constexpr float baseFontSize = 16.0F;

}  // namespace drape
