#pragma once

#include "ui/panel_context.hpp"

#include <string>
#include <string_view>

namespace drape {

/// The rectangle of the item that was drawn last.
[[nodiscard]] UiRect lastItemRect();

/// "kg/m^2" with the powers raised: "kg/m²".
[[nodiscard]] std::string prettyUnit(std::string_view unit);

/// The text, cut with an ellipsis where it would be wider than that.
[[nodiscard]] std::string fitted(std::string_view text, float width);

/// Starts a row: the label at the left, and the cursor where the widget goes, whose width is set to the rest of the
/// row. A row whose value is not the scene's carries a small mark. Gives back the whole row's rectangle.
UiRect beginRow(const PanelContext& context, std::string_view label, bool marked = false);

/// A row that only shows something: the label at the left, the value at the right edge, so that numbers line up.
void valueRow(const PanelContext& context, std::string_view label, std::string_view value,
              const ImVec4& colour = palette().text);

/// A row of text: the label at the left, and what there is to say where the widgets of other rows begin, on as many
/// lines as it needs.
void factRow(const PanelContext& context, std::string_view label, std::string_view fact);

/// True while the mouse is over the row and nothing lies over it.
[[nodiscard]] bool hoversRow(const UiRect& row);

/// True once the mouse has stayed on the thing with that name for a moment.
[[nodiscard]] bool hoveredLongEnough(const PanelContext& context, const std::string& name);

/// A tooltip of a readable width around what is drawn in between; beside the row, where it hides no other, or at the
/// mouse.
void beginExplanation(const PanelContext& context, const UiRect* row = nullptr);
void endExplanation();

/// A tooltip with one sentence for the item that was drawn last.
void explainItem(const PanelContext& context, const std::string& name, std::string_view sentence);

/// A paragraph in the colour of explanations.
void mutedText(std::string_view text, const ImVec4& colour = palette().muted);

/// A paragraph that comes and goes, or changes its length. While the mouse holds something it keeps its height, so that
/// nothing moves away from under the mouse.
void steadyText(PanelContext& context, const std::string& name, const std::string& text, const ImVec4& colour);

/// The signs on the transport buttons; drawn, because the typeface has none of them.
enum class Icon { None, Play, Pause, Step, Reset };

/// A button with a sign and a word, remembered under `name`. Gives back whether it was pressed.
bool iconButton(PanelContext& context, const std::string& name, Icon icon, std::string_view word, float width,
                bool strong = false);

/// The heading of a section that folds; gives back whether it is open. Close an open one with endSection().
bool beginSection(PanelContext& context, const std::string& title, bool openAtFirst);
void endSection();

}  // namespace drape
