#pragma once

#include "ui/panel_context.hpp"
#include "ui/wording.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace drape::ui {

/// The rectangle of the last item.
[[nodiscard]] UiRect lastItemRect();

/// The unit with raised powers: "kg/m²" for "kg/m^2".
[[nodiscard]] std::string prettyUnit(std::string_view unit);

/// The unit as a text to show: a symbol, or the word "degrees".
[[nodiscard]] text::Sentence unitInWords(std::string_view unit);

/// The text, cut with an ellipsis to at most that width.
[[nodiscard]] std::string fitted(std::string_view text, float width);

/// The width of the text in a closed list, beside its arrow, where the next widget is one.
[[nodiscard]] float widthBesideArrow();

/// Starts a row: draws the label at the left, in two lines if needed, moves the cursor to the widget, and sets its
/// width to the rest of the row. A row whose value differs from the scene's gets a small mark. Returns the rectangle of
/// the whole row.
UiRect beginRow(const PanelContext& context, const Wording& label, bool marked = false);

/// A row that shows a value: the label at the left, the value at the right edge, so that numbers align.
void valueRow(const PanelContext& context, const Wording& label, std::string_view value,
              const ImVec4& colour = palette().text);

/// A row of text: the label at the left, the text in the column of the widgets, with line breaks.
void factRow(const PanelContext& context, const Wording& label, std::string_view fact);

/// A label in the present language whose identity is a name that does not change with it.
[[nodiscard]] std::string labelOf(const PanelContext& context, const Wording& wording, std::string_view name);

/// Whether the mouse is over the row and nothing covers it.
[[nodiscard]] bool hoversRow(const UiRect& row);

/// Whether the mouse has stayed on the thing with that name for a moment.
[[nodiscard]] bool hoveredLongEnough(const PanelContext& context, const std::string& name);

/// Begins a tooltip of readable width. It appears beside the row, where it hides no other row, or at the mouse.
void beginExplanation(const PanelContext& context, const UiRect* row = nullptr);
void endExplanation();

/// A tooltip with one sentence for the last item.
void explainItem(const PanelContext& context, const std::string& name, const Wording& sentence);

/// A paragraph in the colour of explanations.
void mutedText(std::string_view text, const ImVec4& colour = palette().muted);

/// A paragraph that appears and disappears or changes its length. It keeps its height while a mouse button is down, so
/// that nothing moves away from the mouse.
void steadyText(PanelContext& context, const std::string& name, const std::string& text, const ImVec4& colour);

/// The icons of the transport buttons. They are drawn, because the font has none of them.
enum class Icon { None, Play, Pause, Step, Reset };

/// A button with an icon and a word, stored under `name`. Returns whether it was pressed.
bool iconButton(PanelContext& context, const std::string& name, Icon icon, const Wording& word, float width,
                bool strong = false);

/// The width of a button with that word, and at least `width`.
[[nodiscard]] float widthOfButton(const PanelContext& context, const Wording& word, float width);

/// One of a few choices that stand side by side.
struct Segment {
  std::string_view word;   ///< for tests
  std::string_view title;  ///< as it is shown, in English
  bool isName = false;     ///< whether the title is the same in all languages
};

/// Draws choices side by side in the width of the next item, each stored as "NAME=WORD". @return the chosen one
std::size_t segments(PanelContext& context, const std::string& name, std::span<const Segment> choices,
                     std::size_t chosen);

/// The heading of a collapsible section; returns whether it is open. Close an open section with endSection(). It begins
/// as the user left it. @param openNow opens a closed section
bool beginSection(PanelContext& context, const std::string& title, bool openAtFirst, bool openNow = false);
void endSection();

/// The heading of settings that are hidden at first, within a section; stored under "fold." and `name`. Returns whether
/// it is open. @param openNow opens a closed one
bool beginFold(PanelContext& context, const std::string& title, const std::string& name, bool openNow = false);

/// Scrolls to a row that the search shows, and marks it for a moment. Call it after the row is drawn.
void revealRow(PanelContext& context, const std::string& key, const UiRect& row);

}  // namespace drape::ui
